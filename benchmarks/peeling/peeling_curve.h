// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_benchmarks_peeling_curve_h
#define setae_benchmarks_peeling_curve_h

#include <setae/fiber_problem.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace Setae
{
  /**
   * Two adhesive fibers are pulled apart (SBIP Sec. 8.1): what the benchmarks of
   * this folder have in common.
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



    /** What the clocks of the program say about one part of it. */
    struct Section
    {
      double       cpu_time = 0.; ///< [s]
      unsigned int n_calls  = 0;

      double
      per_call() const
      {
        return cpu_time / n_calls;
      }
    };



    /** Place and height of a maximum. */
    struct Peak
    {
      double opening, force;
    };



    /** A whole run. */
    struct Curve
    {
      std::vector<Point>             points; ///< all load steps
      RunSummary                     summary;
      std::map<std::string, Section> sections;

      /** How many points there are before the fibers snap apart. */
      std::size_t
      n_bonded() const
      {
        return std::find_if(points.begin(),
                            points.end(),
                            [](const Point &p) { return p.is_snap; }) -
               points.begin();
      }

      /** The largest force, by the parabola through the three highest points. */
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
        const double x = .5 * (a.opening + b.opening - s / curvature);
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



    inline std::string
    read_file(const std::string &name)
    {
      std::ifstream stream(name);
      AssertThrow(stream.good(), dealii::ExcFileNotOpen(name));
      std::ostringstream text;
      text << stream.rdbuf();
      return text.str();
    }



    inline std::map<std::string, Section>
    sections(const dealii::TimerOutput &timer)
    {
      std::map<std::string, Section> result;
      for (const auto &[name, seconds] :
           timer.get_summary_data(dealii::TimerOutput::total_cpu_time))
        result[name].cpu_time = seconds;
      for (const auto &[name, n] :
           timer.get_summary_data(dealii::TimerOutput::n_calls))
        result[name].n_calls = static_cast<unsigned int>(n);
      return result;
    }



    /**
     * Run a scene with two fibers, the second of which is pulled in x by a
     * support called 'right'.
     *
     * @param prm The text of the scene.
     * @throws ExcRun where a load step has no solution.
     */
    inline Curve
    run(const std::string &prm, const Overrides &overrides = {})
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

      Curve curve;
      curve.summary = problem.run([&](const StepRecord &record) {
        const auto support =
          std::find_if(record.supports.begin(),
                       record.supports.end(),
                       [](const SupportReport &s) { return s.name == "right"; });
        const State state = problem.state();
        curve.points.push_back({record.time,
                                gap(state, 0.) / length,
                                support->reaction[0],
                                record.evaluation.energy,
                                gap(state, .5 * length),
                                record.is_snap});
      });
      curve.sections = sections(problem.timer_output());
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
     * Compare the forces at the times that both curves have while the fibers are
     * bonded in both of them.
     */
    inline Difference
    largest_difference(const Curve &curve, const Curve &reference)
    {
      Difference        result;
      const std::size_t n = curve.n_bonded(), n_reference = reference.n_bonded();
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
