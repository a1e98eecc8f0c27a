// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// A fiber that turns on a rigid arc and is held by repulsion alone (after SSIP
// paper, Sec. 7.2, Fig. 15): vertical reaction and interaction energy by three
// laws, and how they change with the number of integration points. The paper
// has 30, 50 and 64 segments of five points in each cell. Its geometry is not
// given, so that no number of it can be compared but the sum of the reactions.
// Zero is returned if all that must be reached is reached.

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <iostream>
#include <sstream>

#include "../comparison.h"
#include "scene_run.h"

namespace Setae
{
  namespace BeamOnArc
  {
    /** What a run says of one time. */
    struct Point
    {
      double force;  ///< on the arc, vertical [force]
      double energy; ///< of the interaction [energy]
    };

    struct Curve
    {
      std::vector<double> times;
      std::vector<Point>  points;
      double              cpu_time;     ///< [s]
      double              smallest_gap; ///< [length]
      double              imbalance;    ///< largest sum of reactions [force]

      Point
      at(const double time) const
      {
        unsigned int nearest = 0;
        for (unsigned int i = 0; i < times.size(); ++i)
          if (std::abs(times[i] - time) < std::abs(times[nearest] - time))
            nearest = i;
        AssertThrow(std::abs(times[nearest] - time) < 1e-9,
                    dealii::ExcMessage("No load step ends at this time."));
        return points[nearest];
      }
    };

    /** Equal segments of 5 points, or graded ones of 8 points. */
    struct Points
    {
      unsigned int n_segments;
      double       tolerance; ///< or zero for equal ones

      std::string
      name() const
      {
        std::ostringstream text;
        if (tolerance > 0.)
          text << "graded " << tolerance;
        else
          text << n_segments << " x 5";
        return text.str();
      }
    };

    Curve
    run(const std::string &prm, const std::string &law, const Points &points)
    {
      const SceneRun run(prm,
                         "beam_on_arc.prm",
                         {"interactions/steric/law=" + law,
                          "interactions/steric/integration segments=" +
                            std::to_string(points.n_segments),
                          "interactions/steric/integration tolerance=" +
                            std::to_string(points.tolerance),
                          std::string("interactions/steric/gauss points=") +
                            (points.tolerance > 0. ? "8" : "5")});
      Curve          curve;
      curve.imbalance = 0.;
      for (const StepRecord &record : run.records)
        {
          Tensor<1, 3> sum;
          for (const SupportReport &support : record.supports)
            sum += support.reaction;
          curve.imbalance = std::max(curve.imbalance, sum.norm());
          curve.times.push_back(record.time);
          curve.points.push_back({record.supports[2].reaction[2],
                                  record.evaluation.energies.back()});
        }
      curve.cpu_time     = run.summary.cpu_time;
      curve.smallest_gap = run.summary.smallest_gap;
      return curve;
    }



    class Study
    {
    public:
      explicit Study(const std::string &folder)
        : prm(read_file(folder + "/../../prm/beam_on_arc.prm"))
        , curves("beam_on_arc_curves.csv")
        , errors("beam_on_arc_errors.csv")
      {
        curves << "law,segments,time,vertical reaction,interaction energy\n";
        errors << "law,segments,force error at 1,energy error at 1,"
                  "force error at 2,energy error at 2,CPU time [s]\n";
      }

      /** @return Whether everything that must be reached is reached. */
      bool
      run()
      {
        for (const char *law :
             {"disk-cylinder", "tabulated-disk-cylinder", "disk-disk"})
          add_law(law);

        comparison.add({"smallest gap",
                        Comparison::none,
                        smallest_gap,
                        Requirement::at_least(1e-3)});
        comparison.add(
          {"sum of reactions", 1e-10, imbalance, Requirement::at_most(1e-10)});

        std::cout
          << "A fiber turns on a rigid arc, after SSIP Sec. 7.2: crossing "
             "at t = 1, parallel at t = 2.\nErrors relative to the same "
             "law with "
          << n_reference
          << " segments of 5 points. Graded segments have 8 points.\n\n";
        table.write_text(std::cout, TableHandler::org_mode_table);
        std::cout << "\nThe worst of all runs:\n\n";
        comparison.print(std::cout);
        comparison.write_csv("beam_on_arc.csv");
        return comparison.succeeds();
      }

    private:
      using TableHandler = dealii::TableHandler;

      static constexpr unsigned int n_reference = 128;

      void
      add_law(const std::string &law)
      {
        const Curve reference = BeamOnArc::run(prm, law, {n_reference, 0.});
        std::vector<Sample> equal;
        for (const unsigned int n : {10, 20, 30, 50, 64})
          equal.push_back(add(law, {n, 0.}, reference));
        equal.push_back({0., reference.cpu_time});
        for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
          {
            const Sample graded = add(law, {1, tolerance}, reference);
            for (const Sample &sample : equal)
              if (sample.error <= graded.error)
                {
                  comparison.add({law + ", " + Points{1, tolerance}.name() +
                                    ": CPU time of equal segments as good "
                                    "over graded",
                                  Comparison::none,
                                  sample.cpu_time / graded.cpu_time});
                  break;
                }
            comparison.add({law + ", " + Points{1, tolerance}.name() +
                              ": error of the energy over tolerance",
                            Comparison::none,
                            graded.error / tolerance,
                            Requirement::at_most(10.)});
          }
        record(law, {n_reference, 0.}, reference, reference);
      }

      /** Error of the energy, the larger one of both times, and cost. */
      struct Sample
      {
        double error, cpu_time;
      };

      Sample
      add(const std::string &law, const Points &points, const Curve &reference)
      {
        const Curve curve = BeamOnArc::run(prm, law, points);
        record(law, points, curve, reference);
        double error = 0.;
        for (const double time : {1., 2.})
          error =
            std::max(error,
                     std::abs(
                       curve.at(time).energy / reference.at(time).energy - 1.));
        return {error, curve.cpu_time};
      }

      void
      record(const std::string &law,
             const Points      &points,
             const Curve       &curve,
             const Curve       &reference)
      {
        smallest_gap = std::min(smallest_gap, curve.smallest_gap);
        imbalance    = std::max(imbalance, curve.imbalance);

        table.add_value("law", law);
        table.add_value("segments", points.name());
        errors << law << ',' << points.name();
        for (const double time : {1., 2.})
          {
            const Point value = curve.at(time), exact = reference.at(time);
            const std::string at = time == 1. ? ", t = 1" : ", t = 2";
            add_value("force" + at, value.force, exact.force);
            add_value("energy" + at, value.energy, exact.energy);
          }
        table.add_value("smallest gap", curve.smallest_gap);
        table.set_precision("smallest gap", 5);
        table.add_value("CPU time [s]", curve.cpu_time);
        table.set_precision("CPU time [s]", 2);
        errors << ',' << curve.cpu_time << '\n';

        for (unsigned int i = 0; i < curve.times.size(); ++i)
          curves << law << ',' << points.name() << ',' << curve.times[i] << ','
                 << curve.points[i].force << ',' << curve.points[i].energy
                 << '\n';
      }

      void
      add_value(const std::string &name, const double value, const double exact)
      {
        const double error = std::abs(value / exact - 1.);
        table.add_value(name, value);
        table.set_precision(name, 5);
        table.set_scientific(name, true);
        table.add_value("error of " + name, error);
        table.set_precision("error of " + name, 1);
        table.set_scientific("error of " + name, true);
        errors << ',' << error;
      }

      const std::string prm;
      std::ofstream     curves, errors;
      TableHandler      table;
      Comparison        comparison;
      double            smallest_gap = std::numeric_limits<double>::infinity();
      double            imbalance    = 0.;
    };
  } // namespace BeamOnArc
} // namespace Setae



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      return Setae::BeamOnArc::Study(argv[1]).run() ? 0 : 1;
    }
  catch (const std::exception &error)
    {
      std::cerr << error.what() << std::endl;
      return 1;
    }
}
