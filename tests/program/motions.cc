// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gtest/gtest.h>

#include <setae/fiber_problem.h>

#include <cmath>
#include <memory>
#include <set>
#include <sstream>

using namespace Setae;

namespace
{
  /** EI = 1, rho A = 1, length 1, in a plane. */
  const std::string rod = R"(
set coordinates = x, y
subsection fibers
  set names = rod
  subsection rod
    set centerline     = s; 0; 0
    set radius         = 0.01
    set youngs modulus = 1.2732395447351628e8
    set density        = 3183.098861837907
    set cells          = 8
  end
end
subsection loads
  set names = tip
end
subsection dynamics
  set integrator = generalized-alpha
end
subsection newton
  set residual tolerance  = 1e-10
  set increment tolerance = 1e-9
end
subsection output
  set fields = false
end
)";

  const std::string clamp = R"(
subsection supports
  set names = clamp
  subsection clamp
    set displacement = 0; 0; 0
    set tangent      = free; 0; 0
  end
end
)";

  struct Motions
  {
    Motions(const std::string &text, const std::vector<std::string> &overrides)
      : problem(Scene::read(text, "motion.prm", overrides),
                MPI_COMM_SELF,
                screen)
    {
      summary = problem.run(
        [this](const StepRecord &record) { records.push_back(record); });
    }

    const StepRecord &
    last() const
    {
      return records.back();
    }

    std::ostringstream      screen;
    FiberProblem            problem;
    std::vector<StepRecord> records;
    RunSummary              summary;
  };

  using Overrides = std::vector<std::string>;

  Overrides
  operator+(Overrides first, const Overrides &second)
  {
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }

  /** The first mode of a cantilever, with the amplitude @p a of the velocity. */
  std::string
  first_mode(const std::string &a)
  {
    const std::string w = "1.8751040687119611", q = "0.7340955137589078";
    return "fibers/rod/initial velocity=0; " + a + "*(cosh(" + w + "*s)-cos(" +
           w + "*s)-" + q + "*(sinh(" + w + "*s)-sin(" + w + "*s))); 0";
  }

  constexpr double first_frequency =
    3.5160152685; // lambda^2 sqrt(EI/rho A)/l^2

  double
  deviation(const std::vector<StepRecord>                         &records,
            const std::function<double(const StepRecord &record)> &value)
  {
    double largest = 0.;
    for (const StepRecord &record : records)
      largest =
        std::max(largest, std::abs(value(record) - value(records.front())));
    return largest;
  }

  double
  total_energy(const StepRecord &record)
  {
    return record.motion->total_energy;
  }
} // namespace



TEST(Motion, VibratesWithTheFrequencyOfACantilever)
{
  const double  period = 2. * M_PI / first_frequency;
  const Motions motion(rod + clamp,
                       {first_mode("1e-3"),
                        "dynamics/rho infinity=1",
                        "dynamics/end time=" + std::to_string(10. * period),
                        "dynamics/time step=" + std::to_string(period / 200.)});

  // Where the tip passes its initial place upwards for the tenth time.
  std::vector<double> crossings;
  for (unsigned int i = 1; i + 1 < motion.records.size(); ++i)
    {
      const StepRecord &a = motion.records[i], &b = motion.records[i + 1];
      const double      u = a.loads[0].displacement[1],
                   v      = b.loads[0].displacement[1];
      if (u < 0. && v >= 0.)
        crossings.push_back(a.time + (b.time - a.time) * u / (u - v));
    }
  ASSERT_GE(crossings.size(), 9u);
  const double measured = 2. * M_PI * 9. / crossings[8];

  // The trapezoidal rule is slower by (omega h)^2/12, 8e-5 of the frequency.
  EXPECT_NEAR(measured / first_frequency, 1. - 8.2e-5, 1e-5);
}



TEST(Motion, KeepsTheEnergyOfASmallVibrationWithoutNumericalDamping)
{
  const Motions motion(rod + clamp,
                       {first_mode("1e-3"),
                        "dynamics/rho infinity=1",
                        "dynamics/end time=30",
                        "dynamics/time step=0.02"});
  EXPECT_LT(deviation(motion.records, total_energy),
            1e-7 * motion.last().motion->total_energy);

  const Motions damped(rod + clamp,
                       {first_mode("1e-3"),
                        "dynamics/rho infinity=0",
                        "dynamics/end time=30",
                        "dynamics/time step=0.02"});
  EXPECT_LT(damped.last().motion->total_energy,
            .999 * motion.last().motion->total_energy);
}



// A large vibration: the energy oscillates by an amount of second order, but
// does not drift.
TEST(Motion, KeepsTheEnergyOfALargeVibrationToSecondOrder)
{
  std::vector<double> deviations;
  for (const std::string h : {"0.004", "0.002"})
    {
      const Motions motion(rod + clamp,
                           {first_mode("0.7"),
                            "fibers/rod/cells=4",
                            "fibers/rod/youngs modulus=1.2732395447351628e4",
                            "fibers/rod/radius=0.1",
                            "fibers/rod/density=31.83098861837907",
                            "dynamics/rho infinity=1",
                            "dynamics/end time=4",
                            "dynamics/time step=" + h});
      deviations.push_back(deviation(motion.records, total_energy) /
                           motion.last().motion->total_energy);
    }
  EXPECT_LT(deviations[1], 2e-3);
  EXPECT_NEAR(std::log2(deviations[0] / deviations[1]), 2., .3);
}



TEST(Motion, KeepsTheEnergyOfALargeVibrationInLargeStepsIfTold)
{
  std::vector<double> deviations;
  for (const std::string integrator :
       {"generalized-alpha", "energy-conserving"})
    {
      const Motions motion(rod + clamp,
                           {first_mode("0.7"),
                            "fibers/rod/cells=4",
                            "fibers/rod/youngs modulus=1.2732395447351628e4",
                            "fibers/rod/radius=0.1",
                            "fibers/rod/density=31.83098861837907",
                            "dynamics/integrator=" + integrator,
                            "dynamics/rho infinity=1",
                            "dynamics/end time=4",
                            "dynamics/time step=0.02"});
      deviations.push_back(deviation(motion.records, total_energy) /
                           motion.last().motion->total_energy);
    }
  EXPECT_GT(deviations[0], 5e-4);
  EXPECT_LT(deviations[1], 1e-8);
}



// A force whose energy changes with time, a force and a moment along the fiber:
// what they do is the change of energy.
TEST(Motion, TakesTheEnergyThatItsLoadsGive)
{
  const std::string more = R"(
subsection loads
  set names = tip, line
  subsection tip
    set force  = 0; 3*sin(4*t); 0
    set moment = 0; 0; 2*t
  end
  subsection line
    set at    = all
    set force = t; -2*min(t/0.5, 1); 0
  end
end
)";
  const Motions     motion(rod + clamp + more,
                       {"dynamics/integrator=energy-conserving",
                            "dynamics/rho infinity=1",
                            "dynamics/end time=1",
                            "dynamics/time step=0.01"});
  EXPECT_LT(deviation(motion.records,
                      [](const StepRecord &record) {
                        return record.motion->balance();
                      }),
            1e-8);
  EXPECT_GT(deviation(motion.records, total_energy), .1);
}



TEST(Motion, RepeatsAStepWithTooLargeAnErrorOfTheEnergy)
{
  const Overrides  scene     = {first_mode("0.7"),
                                "fibers/rod/cells=4",
                                "fibers/rod/youngs modulus=1.2732395447351628e4",
                                "fibers/rod/radius=0.1",
                                "fibers/rod/density=31.83098861837907",
                                "dynamics/rho infinity=1",
                                "dynamics/end time=0.5",
                                "dynamics/time step=0.02"};
  constexpr double tolerance = 1e-5;
  const Motions    motion(rod + clamp,
                       scene + Overrides{"dynamics/energy tolerance=" +
                                         std::to_string(tolerance)});
  EXPECT_GT(motion.summary.n_rejected_steps, 0u);
  for (unsigned int i = 1; i < motion.records.size(); ++i)
    EXPECT_LE(std::abs(total_energy(motion.records[i]) -
                       total_energy(motion.records[i - 1])),
              tolerance * (1. + 1e-8));
}



TEST(Motion, OfAFreeFiberKeepsItsMomenta)
{
  // It flies, turns about z, and vibrates.
  const Overrides flight = {
    "coordinates=x, y, z",
    "fibers/rod/initial velocity=0.3; 2*(s-0.3) + sin(5*s); 0.5*cos(4*s)",
    "dynamics/rho infinity=1",
    "dynamics/end time=1"};
  std::vector<double> deviations;
  for (const std::string h : {"0.01", "0.005"})
    {
      const Motions motion(rod, flight + Overrides{"dynamics/time step=" + h});
      const Momenta first = motion.records[0].motion->momenta;
      EXPECT_NEAR(first.linear[0], .3, 1e-12);
      double angular = 0.;
      for (const StepRecord &record : motion.records)
        {
          const Momenta &momenta = record.motion->momenta;
          EXPECT_LT((momenta.linear - first.linear).norm(), 1e-10);
          angular = std::max(angular, (momenta.angular - first.angular).norm());
        }
      deviations.push_back(angular / first.angular.norm());
    }
  EXPECT_LT(deviations[1], 1e-3);
  EXPECT_GT(deviations[0] / deviations[1], 3.);
}



// All velocities equal: nothing but a translation, whatever the integrator.
TEST(Motion, FliesStraightOn)
{
  for (const Overrides &integrator :
       {Overrides{"dynamics/integrator=generalized-alpha"},
        Overrides{"dynamics/integrator=IDA", "dynamics/tolerance=1e-8"}})
    {
      const Motions motion(
        rod,
        integrator + Overrides{"fibers/rod/initial velocity=0.3; -0.2; 0",
                               "dynamics/end time=2",
                               "dynamics/time step=0.1"});
      EXPECT_NEAR(motion.last().loads[0].displacement[0], .6, 1e-8);
      EXPECT_NEAR(motion.last().loads[0].displacement[1], -.4, 1e-8);
      EXPECT_NEAR(motion.last().motion->total_energy, .5 * .13, 1e-8);
    }
}



TEST(Motion, IsDampedToTheStaticElastica)
{
  const Motions      motion(rod + clamp,
                       {"loads/tip/force=0; -10*min(t, 1); 0",
                             "fibers/rod/cells=16",
                             "dynamics/damping=6",
                             "dynamics/rho infinity=0.5",
                             "dynamics/end time=12",
                             "dynamics/tolerance=1e-4",
                             "dynamics/largest step=0.5",
                             "dynamics/time step=0.01"});
  const Tensor<1, 3> u = motion.last().loads[0].displacement;
  EXPECT_NEAR(u[0], -.55500, 2e-4);
  EXPECT_NEAR(u[1], -.81061, 3e-4);
  EXPECT_LT(motion.last().motion->momenta.kinetic_energy, 1e-8);
  EXPECT_NEAR(motion.last().supports[0].reaction[1], 10., 1e-3);
}



// Half a rod too long for its span snaps through: statics has no equilibrium
// near by, the damped motion finds the one on the other side.
TEST(Motion, IsCarriedAcrossAnInstabilityByDamping)
{
  const std::string arch  = R"(
subsection supports
  set names = ends
  subsection ends
    set at           = start, end
    set displacement = 0; 0; 0
  end
end
)";
  const Overrides   scene = {"fibers/rod/centerline=s; 0.1*sin(pi*s); 0",
                             "loads/tip/at=0.5",
                             "loads/tip/force=0; -60*min(t, max(0, 2 - t)); 0",
                             "fibers/rod/cells=8",
                             "dynamics/damping=8",
                             "dynamics/rho infinity=0.5",
                             "dynamics/end time=8",
                             "dynamics/tolerance=1e-4",
                             "dynamics/largest step=0.2",
                             "dynamics/time step=0.01"};
  const Motions     motion(rod + arch, scene);
  // Unloaded again, the arch hangs on the other side, and is at rest.
  EXPECT_LT(motion.last().loads[0].displacement[1], -.15);
  EXPECT_LT(motion.last().motion->momenta.kinetic_energy, 1e-6);
  EXPECT_GT(motion.summary.n_rejected_steps, 0u);
}



// The rod is shaken at its clamp; what the support does is the change of
// energy.
TEST(Motion, TakesTheEnergyThatItsSupportGives)
{
  std::vector<double> differences;
  for (const std::string h : {"0.01", "0.005"})
    {
      const Motions motion(
        rod + clamp,
        {"supports/clamp/displacement=0; 0.05*(1-cos(5*t)); 0",
         "dynamics/rho infinity=1",
         "dynamics/damping=0.5",
         "dynamics/end time=2",
         "dynamics/time step=" + h});
      double largest = 0., energy = 0.;
      for (const StepRecord &record : motion.records)
        {
          const MotionReport &m = *record.motion;
          energy                = std::max(energy, m.total_energy);
          largest =
            std::max(largest,
                     std::abs(m.total_energy + m.dissipation - m.support_work));
        }
      differences.push_back(largest / energy);
      EXPECT_NEAR(motion.last().supports[0].displacement[1],
                  .05 * (1. - std::cos(10.)),
                  1e-12);
    }
  EXPECT_LT(differences[1], 2e-3);
  EXPECT_GT(differences[0] / differences[1], 3.);
}



TEST(Motion, IsTheSameByGeneralizedAlphaAndIda)
{
  const Overrides scene = {
    "supports/clamp/displacement=0; 0.05*(1-cos(5*t)); 0",
    "loads/tip/force=0; -2*sin(3*t); 0",
    "dynamics/damping=0.5",
    "dynamics/end time=1"};
  const Motions alpha(rod + clamp,
                      scene + Overrides{"dynamics/time step=1e-3"});
  const Motions ida(rod + clamp,
                    scene + Overrides{"dynamics/integrator=IDA",
                                      "dynamics/tolerance=1e-7",
                                      "dynamics/time step=0.01"});
  ASSERT_EQ(ida.records.size(), 101u);
  for (unsigned int i = 0; i <= 100; ++i)
    {
      const StepRecord &a = alpha.records[10 * i], &b = ida.records[i];
      EXPECT_NEAR(a.time, b.time, 1e-10);
      const auto u = a.loads[0].displacement, v = b.loads[0].displacement;
      EXPECT_LT((u - v).norm(), 1e-4);
      EXPECT_NEAR(total_energy(a), total_energy(b), 1e-3);
    }
}



TEST(Motion, HasOnlyWhatItNeeds)
{
  const Motions         motion(rod + clamp,
                       {"dynamics/end time=0.01", "dynamics/time step=1e-3"});
  std::set<std::string> sections;
  for (const auto &[name, time] :
       motion.problem.timer_output().get_summary_data(
         dealii::TimerOutput::total_wall_time))
    sections.insert(name);
  EXPECT_EQ(
    sections,
    (std::set<std::string>{"setup", "strain", "load", "inertia", "solve"}));
  EXPECT_TRUE(motion.last().motion.has_value());

  const Motions statics(rod + clamp, {"dynamics/integrator=none"});
  EXPECT_FALSE(statics.last().motion.has_value());
}
