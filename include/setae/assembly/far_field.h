// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_far_field_h
#define setae_assembly_far_field_h

#include <deal.II/base/array_view.h>
#include <deal.II/base/quadrature.h>

#include <setae/assembly/curve_gaps.h>
#include <setae/assembly/global_system.h>
#include <setae/assembly/interaction_roles.h>
#include <setae/far_field/cluster_tree.h>
#include <setae/far_field/taylor_expansion.h>
#include <setae/interactions/line_sites.h>

#include <array>
#include <memory>
#include <vector>

namespace Setae
{
  /**
   * The pairs of cells of a long-range interaction that are so far apart that
   * the moments of clusters of cells can stand for them, by the law `monopole`:
   * points on the centerlines that interact by the point potential.
   *
   * It decides which pairs of cells these are, with a bound of the error
   * (TaylorExpansion::relative_error()), leaves the near ones to the caller,
   * and adds the rest in a time that grows about as n log n with the number of
   * cells. The energy is that of the truncated series, and its gradient and
   * Hessian are exact; the sum of the forces is zero. Only when cells have
   * moved by half of the skin, the clusters are made anew, which changes energy
   * and forces by no more than their error.
   *
   * Every rank computes the moments of all clusters, and the potential where it
   * owns cells.
   */
  class FarField
  {
  public:
    using Vector = dealii::TrilinosWrappers::MPI::Vector;

    /** @p rule makes the points of a cell, the same as of near pairs. */
    FarField(const FiberSystem           &fibers,
             const InteractionParameters &parameters,
             const InteractionRoles      &roles,
             const dealii::Quadrature<1> &rule);

    /** Whether cells have moved too far for the clusters there are. */
    bool
    needs_rebuild(const State &state) const;

    /**
     * Divide all pairs.
     *
     * @param sources the cells for which near_targets() are wanted
     */
    void
    build(const State &state, const std::vector<unsigned int> &sources);

    /** The cells that are near the source of index @p i, ascending. */
    dealii::ArrayView<const unsigned int>
    near_targets(const unsigned int i) const
    {
      return near[i];
    }

    /** Whether a cell takes part. */
    bool
    knows(const unsigned int cell) const
    {
      return tree.cluster_of_cell[cell] != ClusterTree::none;
    }

    /** Pairs of clusters that stand for all far pairs of cells. */
    std::size_t
    n_far_pairs() const
    {
      return pairs.far.size();
    }

    /** Pairs of cells that are left, on all ranks. */
    std::size_t
    n_near_pairs() const
    {
      return pairs.near.size();
    }

    /**
     * Add the far pairs, times @p strength: to the matrix only what couples a
     * cell with itself, the rest is left to add_tangent_product().
     *
     * @return The energy of the cells of this rank.
     */
    double
    assemble(const State  &state,
             const double  strength,
             const Request request,
             GlobalSystem &system);

    /**
     * Add what the residual changes by with the positions of other cells, for
     * the change of the displacement in @p direction, about the state of the
     * last assemble() with a tangent matrix. To be compressed.
     */
    void
    add_tangent_product(const State &direction, Vector &product) const;

    /**
     * The forces per length on the points of an owned cell, in the potential of
     * the last assemble().
     */
    std::vector<Tensor<1, 3>>
    site_forces(const unsigned int           cell,
                const std::vector<LineSite> &sites,
                const double                 strength) const;

    /** Let a report see the curves of far pairs of cells. */
    void
    see_gaps(const State     &state,
             const CurveGaps &curve_gaps,
             GapReport       &report) const;

    /** The order of the expansion for a given bound of the error. */
    static unsigned int
    order_for(const double tolerance);

  private:
    void
    see_gaps(const unsigned int A,
             const unsigned int B,
             const State       &state,
             const CurveGaps   &curve_gaps,
             GapReport         &report) const;

    /** A bound from below for the distance of the cells of two clusters. */
    double
    least_distance(const unsigned int A, const unsigned int B) const;

    /** Whether some cells of two clusters do not interact for their nearness.
     */
    bool
    has_excluded_cells(const unsigned int A, const unsigned int B) const;

    void
    find_powers(const State &state);

    void
    find_owned_clusters();

    template <typename AddPoint>
    std::vector<double>
    moments(const std::vector<HermiteCell<>> &cells,
            const AddPoint                   &add_point) const;

    std::vector<double>
    potential_of(const std::vector<double> &moments) const;

    std::vector<Tensor<1, 3>>
    forces_of(const std::vector<double>   &local,
              const unsigned int           cell,
              const std::vector<LineSite> &sites,
              const double                 strength) const;

    double
    add_cell(const unsigned int   cell,
             const HermiteCell<> &current,
             const double         strength,
             const Request        request,
             GlobalSystem        &system) const;

    double *
    of_cluster(std::vector<double> &coefficients, const unsigned int i) const
    {
      return coefficients.data() + std::size_t(i) * expansion.size();
    }

    const double *
    of_cluster(const std::vector<double> &coefficients,
               const unsigned int         i) const
    {
      return coefficients.data() + std::size_t(i) * expansion.size();
    }

    const FiberSystem          &fibers;
    const InteractionRoles     &roles;
    const dealii::Quadrature<1> rule;
    const double                tolerance;
    const bool                  self_interaction;
    const unsigned int          n_excluded_neighbors;
    const TaylorExpansion       expansion;
    double                      skin; ///< allowance for motion [length]

    std::vector<ClusterTree::Chain> chains;
    std::vector<double>             charge_per_length; ///< of each fiber

    /** Fibers that are source only, target only, and both. */
    std::array<std::vector<unsigned int>, 3> groups;

    // As of the last build().
    ClusterTree                             tree;
    std::vector<ClusterTree::ControlPoints> reference;
    std::vector<std::vector<double>>        powers;
    std::vector<bool>                       is_owned; ///< in part
    ClusterTree::Pairs                      pairs;
    std::vector<std::vector<unsigned int>>  near;

    // As of the last assemble().
    std::vector<double>        local;
    std::vector<HermiteCell<>> linearization;
    double                     linearized_strength = 0.;
  };
} // namespace Setae

#endif
