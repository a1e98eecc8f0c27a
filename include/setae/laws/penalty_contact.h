// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_laws_penalty_contact_h
#define setae_laws_penalty_contact_h

#include <setae/base/invariants.h>
#include <setae/base/law_derivatives.h>

#include <limits>
#include <string>

namespace Setae
{
  /**
   * Line contact (Meier, Popp, Wall 2016): where the gap to the closest point
   * of the target is negative, the energy per length of the source is
   * @f[ \tilde\pi(g) = \tfrac{\varepsilon}{2} g^2, \qquad g < 0, @f]
   * so that the fibers press on each other with the force @f$\varepsilon|g|@f$
   * per length. It depends on no angle, so that a fiber is a row of spheres,
   * with round ends. Nothing of the tangent matrix is continuous at g = 0, but
   * energy and force are.
   */
  class PenaltyContact
  {
  public:
    static constexpr const char *name          = "penalty-contact";
    static constexpr Invariants  depends_on    = Invariants::gap_angle;
    static constexpr bool        is_long_range = false;

    static std::string
    description()
    {
      return "line contact: a force per length proportional to the penetration "
             "of the fibers, by the factor 'penalty'; all ends are round, half "
             "a sphere beyond the last point";
    }

    /** @param penalty Force per length and penetration [force/length^2]. */
    explicit PenaltyContact(const double penalty)
      : penalty(penalty)
    {}

    /** Energy per length of the source and its derivatives. */
    GapAngleDerivatives
    operator()(const double gap, const double /*cosine*/) const
    {
      GapAngleDerivatives result;
      if (gap < 0.)
        {
          result.value = .5 * penalty * gap * gap;
          result.g     = penalty * gap;
          result.gg    = penalty;
        }
      return result;
    }

    /** The energy alone, on any number type. */
    template <typename Number>
    Number
    energy(const Number &gap, const Number & /*cosine*/) const
    {
      return gap < 0. ? Number(.5 * penalty * gap * gap) : Number(0.);
    }

    /** The gap [length] from which on there is no contact. */
    double
    cutoff() const
    {
      return 0.;
    }

    /** Whether the law can be evaluated at @p gap: at every one. */
    bool
    admits(const double /*gap*/) const
    {
      return true;
    }

  private:
    double penalty;
  };
} // namespace Setae

#endif
