// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_assembly_load_h
#define setae_assembly_load_h

#include <setae/assembly/energy_term.h>

#include <optional>

namespace Setae
{
  /**
   * Dead forces and moments about fixed axes, at points of fibers or along
   * them.
   *
   * A force is conservative and has the energy -f.u. A moment m does the work
   * @f$m\cdot(t\times\delta t)@f$ with the unit tangent t, so it acts on r' with
   * the force @f$m\times r'/|r'|^2@f$. In space it has no
   * potential, so it adds nothing to the energy, and its tangent matrix is not
   * symmetric.
   */
  class Load : public EnergyTerm
  {
  public:
    Load(const FiberSystem &fibers, const LoadParameters &parameters);

    std::string
    name() const override
    {
      return "load";
    }

    /** Whether there is a point load among its places. */
    bool
    has_point() const
    {
      return first_point.has_value();
    }

    /** The displacement of the first loaded point [length], on every rank. */
    Tensor<1, 3>
    displacement(const State &state) const;

    bool
    has_potential() const override
    {
      return !has_moment;
    }

    double
    assemble(const State  &state,
             const Request request,
             GlobalSystem &system) override;

    /** Of the formulas of the forces, and of the moments. */
    void
    add_external_work(const State               &state,
                      std::vector<ExternalWork> &work) const override;

  private:
    /** A point of an owned cell and its weight, 1 or an arc length. */
    struct Site
    {
      unsigned int cell;
      double       x;
      double       arc_length;
      double       weight;
      unsigned int formula; ///< which of the forces and moments
    };

    void
    add_site(const Site      &site,
             const State     &state,
             const Request    request,
             LocalSystem<12> &local) const;

    void
    collect_line(const unsigned int fiber);

    void
    collect_point(const unsigned int fiber, const std::string &place);

    const FiberSystem &fibers;
    LoadParameters     parameters;

    /** One for all fibers, or one for each if they have i, j or k. */
    std::vector<VectorExpression> forces, moments;

    bool              has_moment;
    std::vector<Site> sites;

    /** Cell and reference coordinate of the first loaded point. */
    std::optional<std::pair<unsigned int, double>> first_point;
  };
} // namespace Setae

#endif
