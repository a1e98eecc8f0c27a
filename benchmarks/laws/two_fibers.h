// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_benchmarks_laws_two_fibers_h
#define setae_benchmarks_laws_two_fibers_h

#include <setae/assembly/interaction.h>
#include <setae/fibers/fiber_system.h>
#include <setae/verification/full_quadrature.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "laws.h"
#include "results.h"

namespace Setae
{
  namespace LawReport
  {
    /** A law as a scene names it, with the choices that matter here. */
    struct SceneLaw
    {
      std::string name; ///< in the report
      std::string law;
      std::string target_ends    = "by law";
      double      cutoff         = 0.; ///< 0: none
      double      regularization = 0.;
    };

    /** All laws of the library that reduce a potential. */
    inline std::vector<SceneLaw>
    scene_laws(const PointPotential &potential)
    {
      std::vector<SceneLaw> result;
      const auto            add = [&](const unsigned int           smallest_exponent,
                           const std::vector<SceneLaw> &laws) {
        if (std::all_of(potential.begin(),
                        potential.end(),
                        [&](const InversePower &power) {
                          return power.exponent >= smallest_exponent;
                        }))
          result.insert(result.end(), laws.begin(), laws.end());
      };
      const std::string sbip = DiskCylinder::name;
      add(DiskDisk::smallest_exponent, {{DiskDisk::name, DiskDisk::name}});
      // Of two bent fibers, sections that are far apart along their axis need
      // not have a positive gap across it.
      constexpr double cutoff = 6., regularization = .05;
      add(OffsetDisks::smallest_exponent,
          {{OffsetDisks::name,
            OffsetDisks::name,
            "by law",
            cutoff,
            regularization}});
      add(DiskCylinder::smallest_exponent,
          {{sbip, sbip, "clamped"}, {sbip + " finite", sbip, "finite"}});
      for (const std::string law : {OrientedDiskCylinder::name,
                                    SectionQuadrature::name,
                                    TabulatedDiskCylinder::name})
        add(TabulatedDiskCylinder::smallest_exponent, {{law, law}});
      add(1, {{Multipole<1>::name, Multipole<1>::name}});
      return result;
    }



    /** A curve by its arc length: position and unit tangent. */
    using FiberCurve =
      std::function<std::pair<Tensor<1, 3>, Tensor<1, 3>>(double)>;

    /** A straight one through @p middle, which is at s = @p s_middle. */
    inline FiberCurve
    straight(const Tensor<1, 3> &middle,
             const Tensor<1, 3> &tangent,
             const double        s_middle)
    {
      return [=](const double s) {
        return std::make_pair(middle + (s - s_middle) * tangent, tangent);
      };
    }

    /**
     * An arc through @p middle.
     *
     * @param to_center Unit vector towards the center of curvature.
     */
    inline FiberCurve
    arc(const Tensor<1, 3> &middle,
        const Tensor<1, 3> &tangent,
        const Tensor<1, 3> &to_center,
        const double        curvature,
        const double        s_middle)
    {
      return [=](const double s) {
        const double phi  = curvature * (s - s_middle);
        const double half = std::sin(.5 * phi);
        return std::make_pair(
          middle + (std::sin(phi) * tangent + 2. * half * half * to_center) /
                     curvature,
          std::cos(phi) * tangent + std::sin(phi) * to_center);
      };
    }



    /**
     * A source and a target of radius and density one that were straight when
     * nothing acted on them, and the interaction of the two in any state: by
     * the laws as the program evaluates them, and by the full quadrature.
     */
    class TwoFibers
    {
    public:
      TwoFibers(const double       source_length,
                const double       target_length,
                const double       cell_length,
                const Distribution distribution = Distribution::volume)
        : distribution(distribution)
        , scene(make_scene(source_length, target_length, cell_length))
        , fibers(scene, MPI_COMM_SELF)
      {}

      State
      state(const FiberCurve &source, const FiberCurve &target) const
      {
        State result;
        result.displacement = fibers.initial;
        result.current      = fibers.initial;
        for (unsigned int f = 0; f < 2; ++f)
          for (unsigned int i = 0; i < fibers.fibers[f].n_cells; ++i)
            {
              const FiberCurve          &curve = f == 0 ? source : target;
              const std::vector<double> &s     = fibers.fibers[f].arc_length;
              HermiteCell<>             &cell =
                result.current[fibers.fibers[f].first_cell + i];
              std::tie(cell.coefficients[0], cell.coefficients[1]) =
                curve(s[i]);
              std::tie(cell.coefficients[2], cell.coefficients[3]) =
                curve(s[i + 1]);
            }
        return result;
      }

      /**
       * What a law gives, energy and the force on the source.
       *
       * @param n_segments Of five Gauss points in each cell.
       * @return A function to be called as often as its time is to be taken; it
       * returns not a number where the law cannot be evaluated because it sees
       * a gap that is not positive.
       */
      std::function<Resultant()>
      by_law(const SceneLaw       &law,
             const PointPotential &potential,
             const State          &state,
             const unsigned int    n_segments) const
      {
        struct Evaluation
        {
          InteractionParameters       parameters;
          State                       state;
          std::unique_ptr<EnergyTerm> term;
        };
        const auto             e = std::make_shared<Evaluation>();
        InteractionParameters &p = e->parameters;
        p.name                   = law.name;
        p.law                    = law.law;
        p.target_ends            = law.target_ends;
        p.cutoff                 = law.cutoff;
        p.regularization         = law.regularization;
        p.source                 = {"source"};
        p.target                 = {"target"};
        p.distribution =
          distribution == Distribution::volume ? "volume" : "surface";
        p.n_segments     = n_segments;
        p.n_gauss_points = 5;
        p.exponents.clear();
        for (const auto &[exponent, prefactor] : potential)
          {
            p.exponents.push_back(exponent);
            p.prefactors.push_back(prefactor);
          }
        e->state = state;
        e->term  = make_interaction(fibers, p);
        e->term->update_couplings(state);
        return [e] {
          Resultant result = e->term->pair_resultants(e->state)[{0, 1}];
          if (e->term->gaps().smallest <= e->term->singular_gap())
            {
              result.energy = std::numeric_limits<double>::quiet_NaN();
              result.force  = result.energy * Tensor<1, 3>({1., 1., 1.});
            }
          return result;
        };
      }

      FullQuadrature
      full(const InversePower             &power,
           const State                    &state,
           const FullQuadratureParameters &parameters) const
      {
        SolidBody source = body(state, 0), target = body(state, 1);
        return full_quadrature(source, target, PointLaw({power}), parameters);
      }

    private:
      static Scene
      make_scene(const double source_length,
                 const double target_length,
                 const double cell_length)
      {
        Scene scene;
        for (const bool is_source : {true, false})
          {
            FiberParameters fiber;
            fiber.name    = is_source ? "source" : "target";
            fiber.length  = is_source ? source_length : target_length;
            fiber.radius  = 1.;
            fiber.n_cells = std::ceil(fiber.length / cell_length - 1e-6);
            scene.fibers.push_back(fiber);
          }
        return scene;
      }

      SolidBody
      body(const State &state, const unsigned int fiber) const
      {
        const Fiber &f    = fibers.fibers[fiber];
        const auto   part = [&f](const std::vector<HermiteCell<>> &cells) {
          const auto begin = cells.begin() + f.first_cell;
          return std::vector<HermiteCell<>>(begin, begin + f.n_cells);
        };
        return SolidBody(FiberChart(part(fibers.initial),
                                    part(state.current),
                                    1.),
                         distribution,
                         MPI_COMM_SELF);
      }

      const Distribution distribution;
      const Scene        scene;
      const FiberSystem  fibers;
    };
  } // namespace LawReport
} // namespace Setae

#endif
