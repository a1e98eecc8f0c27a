// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_energy_term_h
#define setae_assembly_energy_term_h

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <setae/assembly/external_work.h>
#include <setae/assembly/global_system.h>
#include <setae/interactions/line_sites.h>
#include <setae/interactions/resultant.h>
#include <setae/search/passage.h>

#include <optional>
#include <string>

namespace Setae
{
  using GlobalVector = dealii::TrilinosWrappers::MPI::Vector;

  /**
   * One term of the total potential energy of a scene. A term that a scene does
   * not switch on does not exist.
   */
  class EnergyTerm
  {
  public:
    virtual ~EnergyTerm() = default;

    /** Its name in the timing table and in the statistics. */
    virtual std::string
    name() const = 0;

    /**
     * Find out which cells couple in @p state.
     *
     * @return Whether the couplings have changed on this rank.
     */
    virtual bool
    update_couplings(const State &state)
    {
      (void)state;
      return false;
    }

    /** Whether update_couplings() searches at all. */
    virtual bool
    has_search() const
    {
      return false;
    }

    /** Pairs of cells of which at least one is owned that couple. */
    virtual void
    add_couplings(
      std::vector<std::pair<unsigned int, unsigned int>> &cell_pairs) const
    {
      (void)cell_pairs;
    }

    /**
     * Add the contributions of the owned cells to the system.
     *
     * @return The energy of this rank [energy].
     */
    virtual double
    assemble(const State  &state,
             const Request request,
             GlobalSystem &system) = 0;

    /** Whether the tangent matrix needs add_tangent_product(). */
    virtual bool
    has_tangent_product() const
    {
      return false;
    }

    /**
     * Add the product of @p direction with what assemble() has left out of the
     * tangent matrix, in the state of its last call with a tangent matrix. To
     * be compressed.
     */
    virtual void
    add_tangent_product(const State &direction, GlobalVector &product) const
    {
      (void)direction;
      (void)product;
    }

    /** Whether assemble() returns the energy of all its forces. */
    virtual bool
    has_potential() const
    {
      return true;
    }

    /**
     * Append what works from outside on the fibers of this rank, in @p state,
     * which is that of the last assemble(): whatever makes the sum of this
     * energy and the kinetic one change.
     */
    virtual void
    add_external_work(const State &state, std::vector<ExternalWork> &work) const
    {
      (void)state;
      (void)work;
    }

    /** The gaps on this rank that the last assemble() saw. */
    virtual GapReport
    gaps() const
    {
      return {};
    }

    /**
     * A state with a gap below this one is no solution [length]: a law may be
     * regularized there, or fibers overlap.
     */
    virtual double
    smallest_admissible_gap() const
    {
      return -std::numeric_limits<double>::infinity();
    }

    /**
     * What the smallest admissible gap is and what can be changed where a gap
     * is smaller, as the end of a sentence.
     */
    virtual std::string
    small_gap_advice() const
    {
      return "";
    }

    /** At this gap and below, the energy does not exist [length]. */
    virtual double
    singular_gap() const
    {
      return -std::numeric_limits<double>::infinity();
    }

    /**
     * A warning if the points that the scene sets are too far apart for the
     * smallest gap of the last assemble() on this rank, in @p state; or nothing.
     */
    virtual std::string
    unresolved_points(const State &state) const
    {
      (void)state;
      return {};
    }

    /**
     * Where fibers would pass through each other on the straight way between
     * two states, as far as this rank knows.
     */
    virtual std::optional<Passage>
    find_passage(const State &from, const State &to) const
    {
      (void)from;
      (void)to;
      return {};
    }

    /**
     * What pairs of fibers do to each other, as far as this rank knows; not for
     * interactions with a far field, where clusters of fibers act.
     */
    virtual FiberPairResultants
    pair_resultants(const State &state)
    {
      (void)state;
      return {};
    }

    /** The forces at the quadrature points of this rank, for output. */
    virtual void
    add_site_forces(const State &state, std::vector<SiteForce> &forces) const
    {
      (void)state;
      (void)forces;
    }
  };
} // namespace Setae

#endif
