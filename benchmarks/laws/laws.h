// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_benchmarks_laws_laws_h
#define setae_benchmarks_laws_laws_h

#include <setae/laws/all.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

namespace Setae
{
  namespace LawReport
  {
    struct NamedPotential
    {
      std::string    name;
      PointPotential powers;
    };

    inline NamedPotential
    van_der_waals()
    {
      return {"van der Waals", {{6, -1.}}};
    }

    inline NamedPotential
    steric()
    {
      return {"steric", {{12, 1.}}};
    }

    /**
     * Attraction and repulsion of the energies of two parallel cylinders are
     * equal at a gap of R/10.
     */
    inline NamedPotential
    lennard_jones()
    {
      const double k12 = DiskCylinder::coefficient(6, 1.) /
                         DiskCylinder::coefficient(12, 1.) * 1e-6;
      return {"Lennard-Jones", {{6, -1.}, {12, k12}}};
    }

    inline std::vector<NamedPotential>
    short_range_potentials()
    {
      return {van_der_waals(), steric(), lennard_jones()};
    }

    inline NamedPotential
    coulomb()
    {
      return {"Coulomb", {{1, 1.}}};
    }

    /** Two fibers alike: radii and densities of one. */
    inline SectionPair
    equal_sections(const Distribution distribution = Distribution::volume)
    {
      return {1., 1., 1., 1., distribution};
    }

    constexpr double sum_of_radii = 2.;

    /** A source of radius and densities of one beside targets of these radii.
     */
    const std::vector<double> unequal_radii = {.1, .3, 3., 10.};

    inline SectionPair
    sections_with(const double radius_2)
    {
      return {1., radius_2, 1., 1., Distribution::volume};
    }



    namespace internal
    {
      template <typename Law, typename Visitor>
      void
      visit_law(const PointPotential &potential,
                const SectionPair    &sections,
                const Visitor        &visit)
      {
        if (std::any_of(potential.begin(),
                        potential.end(),
                        [](const InversePower &power) {
                          return power.exponent < Law::smallest_exponent;
                        }))
          return;
        if constexpr (std::is_same_v<Law, SectionQuadrature>)
          for (const LawAccuracy &accuracy :
               {LawAccuracy{2, 5}, LawAccuracy{4, 9}, LawAccuracy{12, 24}})
            visit(std::string(Law::name) + ' ' +
                    std::to_string(accuracy.n_depth) + " x " +
                    std::to_string(accuracy.n_lateral),
                  make_law<Law>(potential, sections, {}, accuracy));
        else
          visit(Law::name, make_law<Law>(potential, sections, {}));
      }

      template <typename... Laws, typename Visitor>
      void
      visit_laws(TypeList<Laws...>,
                 const PointPotential &potential,
                 const SectionPair    &sections,
                 const Visitor        &visit)
      {
        (visit_law<Laws>(potential, sections, visit), ...);
      }
    } // namespace internal

    /**
     * Call `visit(name, law)` for all laws of the library that reduce this
     * potential, without regularization and cutoff.
     */
    template <typename Visitor>
    void
    for_each_law(const PointPotential &potential,
                 const SectionPair    &sections,
                 const Visitor        &visit)
    {
      internal::visit_laws(PotentialLaws(), potential, sections, visit);
    }
  } // namespace LawReport
} // namespace Setae

#endif
