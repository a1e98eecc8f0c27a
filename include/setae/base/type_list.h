// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_base_type_list_h
#define setae_base_type_list_h

#include <setae/base/exceptions.h>

#include <string>

namespace Setae
{
  /**
   * A visible list of types with a static member `name`, from which a parameter
   * gets its allowed values and its documentation, and a program its dispatch.
   */
  template <typename... Types>
  struct TypeList
  {
    /** The list with some more types at its end. */
    template <typename... MoreTypes>
    using with = TypeList<Types..., MoreTypes...>;

    /** The names, separated by '|', as Patterns::Selection wants them. */
    static std::string
    names()
    {
      std::string result;
      ((result += (result.empty() ? "" : "|") + std::string(Types::name)), ...);
      return result;
    }

    /** One sentence for each type. */
    static std::string
    descriptions()
    {
      std::string result;
      ((result += std::string(result.empty() ? "" : "; ") + Types::name + ": " +
                  Types::description()),
       ...);
      return result;
    }

    /**
     * Call `visit(Tag<Type>())` for the type with the given name.
     */
    template <typename Visitor>
    static void
    dispatch(const std::string &name, const Visitor &visit)
    {
      const bool found =
        ((name == Types::name ? (visit(Tag<Types>()), true) : false) || ...);
      AssertThrow(found,
                  ExcInput("'" + name + "' is none of " + names() + "."));
    }

    template <typename T>
    struct Tag
    {
      using type = T;
    };
  };
} // namespace Setae

#endif
