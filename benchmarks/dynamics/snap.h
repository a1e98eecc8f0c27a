// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_benchmarks_dynamics_snap_h
#define setae_benchmarks_dynamics_snap_h

#include <setae/fiber_problem.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "../program_sections.h"

namespace Setae
{
  namespace Snap
  {
    using Overrides = std::vector<std::string>;

    /** What a motion of the two snapping fibers has come to. */
    struct Result
    {
      RunSummary              summary;
      State                   state; ///< at the end
      std::vector<StepRecord> records;

      /** The right node of each cell, at each record [length]. */
      std::vector<std::vector<Tensor<1, 3>>> nodes;

      /**
       * The largest and the last difference of the total energy from that at
       * the time @p start, in parts of it.
       */
      std::array<double, 2>
      energy_deviation(const double start) const
      {
        std::array<double, 2> result    = {{0., 0.}};
        double                reference = 0.;
        for (const StepRecord &record : records)
          if (record.time >= start * (1. - 1e-10))
            {
              const double energy = record.motion->total_energy;
              if (reference == 0.)
                reference = energy;
              result[1] = (energy - reference) / std::abs(reference);
              result[0] = std::max(result[0], std::abs(result[1]));
            }
        return result;
      }

      /**
       * The first time at which a node is farther than @p tolerance from where
       * it is in @p other, a run with steps that divide those of this one;
       * infinity if there is none.
       */
      double
      time_of_separation(const Result &other, const double tolerance) const
      {
        unsigned int j = 0;
        for (unsigned int i = 0; i < records.size(); ++i)
          {
            while (j < other.records.size() &&
                   other.records[j].time < records[i].time * (1. - 1e-10))
              ++j;
            for (unsigned int k = 0;
                 j < other.records.size() && k < nodes[i].size();
                 ++k)
              if ((nodes[i][k] - other.nodes[j][k]).norm() > tolerance)
                return records[i].time;
          }
        return std::numeric_limits<double>::infinity();
      }

      /** The largest distance of a node from where it is in @p other. */
      double
      distance(const State &other) const
      {
        double result = 0.;
        for (unsigned int cell = 0; cell < state.current.size(); ++cell)
          for (const unsigned int a : {0, 2})
            result = std::max(result,
                              (state.current[cell].coefficients[a] -
                               other.current[cell].coefficients[a])
                                .norm());
        return result;
      }
    };



    /** Run prm/snap.prm, whose text is @p prm, without writing anything. */
    inline Result
    run(const std::string &prm, const Overrides &overrides)
    {
      std::ostringstream screen;
      FiberProblem       problem(Scene::read(prm, "snap.prm", overrides),
                           MPI_COMM_WORLD,
                           screen);
      Result             result;
      result.summary = problem.run([&](const StepRecord &record) {
        result.records.push_back(record);
        result.nodes.emplace_back();
        for (const HermiteCell<> &cell : problem.state().current)
          result.nodes.back().push_back(cell.coefficients[2]);
      });
      result.state   = problem.state();
      return result;
    }
  } // namespace Snap
} // namespace Setae

#endif
