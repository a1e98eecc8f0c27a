// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_supports_h
#define setae_assembly_supports_h

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_vector.h>

#include <setae/assembly/tangent_directions.h>
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
   * All supports of a scene: degrees of freedom that are prescribed as
   * functions of time, and components of tangents that follow others because
   * their direction is prescribed. All others are free.
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
     * Turn the prescribed directions of tangents to where they are at @p time.
     *
     * @return Whether that changes the pattern of the matrix.
     */
    bool
    move_to(const double time);

    /**
     * The constraints on an increment that takes the @p solution (known on every
     * rank) to the prescribed values at @p time, after move_to().
     *
     * @throws ExcParameter if a prescribed tangent does not have the length 1.
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
     * Take a force, or a residual, to what acts on the free unknowns: those
     * that follow pass theirs on to the ones they follow. Zero at all others.
     */
    void
    project_force(dealii::TrilinosWrappers::MPI::Vector &force) const;

    /**
     * Take a motion, or an increment, to one that leaves the supports at rest:
     * what is prescribed does not move, what follows goes with the free
     * unknowns.
     */
    void
    project_motion(dealii::TrilinosWrappers::MPI::Vector &motion) const;

    /** Take a diagonal matrix to that of the free unknowns, likewise. */
    void
    project_diagonal(dealii::TrilinosWrappers::MPI::Vector &diagonal) const;

    /** Let what follows go with the free unknowns, in a scene with dynamics. */
    void
    follow(dealii::TrilinosWrappers::MPI::Vector &motion) const;

    /** Whether no tangent points against its prescribed direction. */
    bool
    tangents_point_forward(
      const dealii::TrilinosWrappers::MPI::Vector &solution) const
    {
      return directions.point_forward(solution);
    }

    /**
     * Value, velocity and acceleration of each prescribed degree of freedom.
     * The derivatives are taken from values @p spacing apart, none of them
     * before time 0.
     *
     * @throws ExcParameter as increment_to().
     */
    std::map<dealii::types::global_dof_index, std::array<double, 3>>
    motion_at(const double time, const double spacing) const;

    /** Displacements and reactions, the same on every rank. */
    std::vector<SupportReport>
    report(const double                                 time,
           const dealii::TrilinosWrappers::MPI::Vector &residual) const;

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

    /** A function of time, or none for the initial direction or a free one. */
    std::shared_ptr<const VectorExpression>
    parse_direction(const unsigned int index, const Fiber &fiber) const;

    void
    direct_node(const unsigned int                             support,
                const unsigned int                             fiber,
                const unsigned int                             node,
                const std::shared_ptr<const VectorExpression> &direction);

    void
    check_directions() const;

    /** That a prescribed tangent does not prescribe the stretch of a fiber. */
    void
    check_tangents(const double time) const;

    void
    make_constraints();

    void
    hold_rigid_fibers();

    void
    check_every_fiber() const;

    static constexpr unsigned int at_rest_in_rigid_fiber =
      dealii::numbers::invalid_unsigned_int;

    const FiberSystem &fibers;

    /** The formulas, owned once; the degrees of freedom point at them. */
    std::vector<std::unique_ptr<Expression>> expressions;

    /** A node of which components of the tangent are prescribed. */
    struct PrescribedTangent
    {
      unsigned int                      support;
      Tensor<1, 3>                      initial;
      std::array<const Expression *, 3> changes; ///< or none
      std::array<bool, 3>               is_free;
    };

    std::map<dealii::types::global_dof_index, Prescribed> prescribed;
    std::vector<PrescribedTangent>                        prescribed_tangents;
    TangentDirections                                     directions;

    /** The support of the direction of each component of a tangent. */
    std::map<dealii::types::global_dof_index, unsigned int> directed;

    dealii::AffineConstraints<double> homogeneous;
  };
} // namespace Setae

#endif
