// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_benchmarks_peeling_curve_h
#define setae_benchmarks_peeling_curve_h

#include <setae/fiber_problem.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "../program_sections.h"

namespace Setae
{
  /**
   * Two adhesive fibers are pulled apart (SBIP Sec. 8.1): what the benchmarks
   * of this folder have in common.
   */
  namespace Peeling
  {
    /** "section/name=value", applied to a scene. */
    using Overrides = std::vector<std::string>;

    inline Overrides
    operator+(Overrides first, const Overrides &second)
    {
      first.insert(first.end(), second.begin(), second.end());
      return first;
    }



    /** Both fibers with @p n cells. */
    inline Overrides
    cells(const unsigned int n)
    {
      return {"fibers/left/cells=" + std::to_string(n),
              "fibers/right/cells=" + std::to_string(n)};
    }

    /** The quadrature of a cell. */
    inline Overrides
    integration(const unsigned int n_segments,
                const unsigned int n_gauss_points)
    {
      return {"interactions/adhesion/integration segments=" +
                std::to_string(n_segments),
              "interactions/adhesion/gauss points=" +
                std::to_string(n_gauss_points)};
    }

    /**
     * The interaction of SBIP Fig. 11: a point potential with the prefactors
     * @p k6 and @p k12 in the law @p law, and the fibers initially at a gap close
     * to its equilibrium.
     */
    inline Overrides
    point_potential(const std::string &law, const double k6, const double k12)
    {
      // Two cylinders: SBIP eq. 31 with the constant corrected. Two lines of
      // disks with the law of the power 7/2 - m: as the gap closes the integral
      // over one line adds 1/2 to the power, and -8 c_12' / g^9 = 2 c_6' / g^3.
      const double equilibrium = law == "disk-disk" ?
                                   std::pow(7. / 80. * k12 / -k6, 1. / 6.) :
                                   .64170 * std::pow(k12 / -k6, 1. / 6.);
      const auto   number      = [](const double value) {
        std::ostringstream text;
        text.precision(10);
        text << value;
        return text.str();
      };
      const std::string path = "interactions/adhesion/";
      return {path + "law=" + law,
              path + "equilibrium gap=0",
              path + "force minimum=0",
              path + "prefactors=" + number(k6) + "," + number(k12),
              path + "regularization gap=" + number(.7 * equilibrium),
              "constants=l=5, R=0.02, g_eq=" + number(equilibrium)};
    }



    /** One equilibrium of the curve. */
    struct Point
    {
      double time;
      double opening; ///< gap at the supports over the length, u_x/l
      double force;   ///< of both supports [force]
      double energy;  ///< strain and interaction [energy]
      double middle_gap;
      bool   is_snap;
    };



    /** Place and height of a maximum. */
    struct Peak
    {
      double opening, force;
    };



    /** A whole run. */
    struct Curve
    {
      std::vector<Point> points; ///< all load steps
      RunSummary         summary;
      ProgramSections    sections;

      /** How many points there are before the fibers snap apart. */
      std::size_t
      n_bonded() const
      {
        return std::find_if(points.begin(),
                            points.end(),
                            [](const Point &p) { return p.is_snap; }) -
               points.begin();
      }

      /** The largest force, by the parabola through the three highest points.
       */
      Peak
      peak() const
      {
        const auto highest =
          std::max_element(points.begin() + 1,
                           points.end() - 1,
                           [](const Point &a, const Point &b) {
                             return a.force < b.force;
                           });
        const Point &a = *(highest - 1), &b = *highest, &c = *(highest + 1);

        // Newton's form a.force + s (x - a) + curvature (x - a) (x - b).
        const double ab = b.opening - a.opening, bc = c.opening - b.opening;
        const double s         = (b.force - a.force) / ab;
        const double curvature = ((c.force - b.force) / bc - s) / (ab + bc);
        const double x         = .5 * (a.opening + b.opening - s / curvature);
        return {x,
                a.force + (x - a.opening) * (s + curvature * (x - b.opening))};
      }

      /** The last opening with bonded fibers; NaN if they never let go. */
      double
      pull_off() const
      {
        const std::size_t n = n_bonded();
        return n < points.size() ? points[n - 1].opening :
                                   std::numeric_limits<double>::quiet_NaN();
      }

      /** The force of the bonded fibers at an opening, between two points. */
      double
      force(const double opening) const
      {
        const auto end = points.begin() + n_bonded();
        const auto b =
          std::find_if(points.begin() + 1, end, [opening](const Point &p) {
            return p.opening >= opening;
          });
        if (b == end)
          return std::numeric_limits<double>::quiet_NaN();
        const auto a = b - 1;
        return a->force + (b->force - a->force) * (opening - a->opening) /
                            (b->opening - a->opening);
      }

      /** The bonded point closest to an opening. */
      const Point &
      nearest(const double opening) const
      {
        return *std::min_element(points.begin(),
                                 points.begin() + n_bonded(),
                                 [opening](const Point &a, const Point &b) {
                                   return std::abs(a.opening - opening) <
                                          std::abs(b.opening - opening);
                                 });
      }
    };



    /** What a load step without a solution means. */
    enum class Ending
    {
      is_an_error,
      /** Interactions without a potential end where the fibers let go. */
      is_the_end_of_the_curve
    };



    /**
     * Run a scene with two fibers, the second of which is pulled in x by a
     * support called 'right'.
     *
     * @param prm The text of the scene.
     * @param at_the_end Sees the problem after the last step.
     * @throws ExcRun where a load step has no solution, if that is an error.
     */
    inline Curve
    run(const std::string &prm,
        const Overrides   &overrides = {},
        const Ending       ending    = Ending::is_an_error,
        const std::function<void(const FiberProblem &)> &at_the_end = {})
    {
      const Scene        scene = Scene::read(prm, "peeling.prm", overrides);
      std::ostringstream log;
      FiberProblem       problem(scene, MPI_COMM_WORLD, log);
      const FiberSystem &fibers = problem.fiber_system();
      const double       length = scene.fibers[0].length;

      const auto gap = [&](const State &state, const double s) {
        dealii::Tensor<1, 3> r[2];
        for (const unsigned int f : {0, 1})
          {
            const auto [cell, x] = fibers.locate(f, s);
            r[f]                 = state.current[cell].position(x);
          }
        return (r[1] - r[0]).norm() - scene.fibers[0].radius -
               scene.fibers[1].radius;
      };

      Curve      curve;
      const auto add_point = [&](const StepRecord &record) {
        const auto  support = std::find_if(record.supports.begin(),
                                          record.supports.end(),
                                          [](const SupportReport &s) {
                                            return s.name == "right";
                                          });
        const State state   = problem.state();
        curve.points.push_back({record.time,
                                gap(state, 0.) / length,
                                support->reaction[0],
                                record.evaluation.energy,
                                gap(state, .5 * length),
                                record.is_snap});
        curve.summary.add(record);
      };
      try
        {
          curve.summary = problem.run(add_point);
        }
      catch (const ExcRun &)
        {
          if (ending == Ending::is_an_error)
            throw;
        }
      if (at_the_end)
        at_the_end(problem);
      curve.sections = program_sections(problem.timer_output());
      return curve;
    }



    /** How far two curves are apart. */
    struct Difference
    {
      double      largest = 0.; ///< relative to the force there
      double      opening = 0.; ///< where that is
      std::size_t n       = 0;  ///< how many points were compared
    };

    /**
     * Compare the forces at the times that both curves have while the fibers
     * are bonded in both of them.
     */
    inline Difference
    largest_difference(const Curve &curve, const Curve &reference)
    {
      Difference        result;
      const std::size_t n           = curve.n_bonded(),
                        n_reference = reference.n_bonded();
      for (std::size_t i = 1, j = 1; i < n && j < n_reference;)
        {
          const Point &a = curve.points[i], &b = reference.points[j];
          if (std::abs(a.time - b.time) > 1e-9 * b.time)
            {
              ++(a.time < b.time ? i : j);
              continue;
            }
          const double difference = std::abs(a.force / b.force - 1.);
          if (difference > result.largest)
            {
              result.largest = difference;
              result.opening = b.opening;
            }
          ++result.n;
          ++i;
          ++j;
        }
      return result;
    }
  } // namespace Peeling
} // namespace Setae

#endif
