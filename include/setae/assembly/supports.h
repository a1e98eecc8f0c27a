// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_supports_h
#define setae_assembly_supports_h

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_vector.h>

#include <setae/fibers/fiber_system.h>

#include <map>

namespace Setae
{
  /**
   * Displacement and reaction of a named support, for the statistics.
   * Components that the support leaves free are not valid.
   */
  struct SupportReport
  {
    std::string         name;
    std::array<bool, 3> held;
    Tensor<1, 3>        displacement; ///< of its first point [length]
    Tensor<1, 3>        reaction;     ///< on all its points [force]
  };



  /**
   * All supports of a scene: prescribed degrees of freedom as functions of
   * time.
   */
  class Supports
  {
  public:
    /**
     * @throws ExcParameter if a place has no node, a component is held twice,
     * or in a static scene a fiber is not supported at all.
     */
    explicit Supports(const FiberSystem &fibers);

    /**
     * The constraints on an increment that takes the @p solution (known on every
     * rank) to the prescribed values at @p time.
     */
    dealii::AffineConstraints<double>
    increment_to(const double                                 time,
                 const dealii::TrilinosWrappers::MPI::Vector &solution) const;

    /** The constraints on an increment that leaves the supports at rest. */
    const dealii::AffineConstraints<double> &
    at_rest() const
    {
      return homogeneous;
    }

    /**
     * Value, velocity and acceleration of each prescribed degree of freedom.
     * The derivatives are taken from values @p spacing apart, none of them
     * before time 0.
     */
    std::map<dealii::types::global_dof_index, std::array<double, 3>>
    motion_at(const double time, const double spacing) const;

    /** Displacements and reactions, the same on every rank. */
    std::vector<SupportReport>
    report(const double                                 time,
           const dealii::TrilinosWrappers::MPI::Vector &residual) const;

    /** How many degrees of freedom are prescribed. */
    std::size_t
    n_prescribed() const
    {
      return prescribed.size();
    }

  private:
    /** One prescribed degree of freedom. */
    struct Prescribed
    {
      unsigned int      support; ///< or at_rest_in_rigid_fiber
      bool              tangent;
      unsigned int      coordinate;
      const Expression *value;
    };

    void
    add_support(const unsigned int index);

    void
    prescribe_node(const unsigned int                       support,
                   const unsigned int                       fiber,
                   const unsigned int                       node,
                   const bool                               tangent,
                   const std::array<const Expression *, 3> &values);

    void
    hold_rigid_fibers();

    void
    check_every_fiber() const;

    static constexpr unsigned int at_rest_in_rigid_fiber =
      dealii::numbers::invalid_unsigned_int;

    const FiberSystem &fibers;

    /** The formulas, owned once; the degrees of freedom point at them. */
    std::vector<std::unique_ptr<Expression>> expressions;

    std::map<dealii::types::global_dof_index, Prescribed> prescribed;
    dealii::AffineConstraints<double>                     homogeneous;
  };
} // namespace Setae

#endif
