// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

// The numbers of ISSIP Sec. 5 and 6 on forces between fibers that are where
// they are: errors of quadrature and cutoff, the bias of the axis of the
// source. Zero is returned if all that must be reached is reached.

#include <setae/laws/disk_cylinder.h>
#include <setae/scene.h>

#include <iostream>

#include "../comparison.h"
#include "../program_sections.h"
#include "rigid_fibers.h"

namespace Setae
{
  namespace Peeling
  {
    class IssipForces
    {
    public:
      explicit IssipForces(const std::string &folder)
        : scene(Scene::read(read_file(folder + "/../../prm/peeling_issip.prm"),
                            "peeling_issip.prm"))
      {}

      /** @return Whether everything that must be reached is reached. */
      bool
      run()
      {
        add_integrals();
        add_cutoff_integrals();
        add_arcs();

        std::cout << "Forces of rigid fibers, ISSIP Sec. 5 and 6.\n\n";
        comparison.print(std::cout);
        comparison.write_csv("issip_forces.csv");
        return comparison.succeeds();
      }

    private:
      /** The force of a straight fiber on a section, Sec. 6.5 and 6.7. */
      void
      add_integrals()
      {
        const OffsetDisks law   = this->law({});
        const double      end   = .03;
        const double      exact = Rigid::force_of_fiber(law, gap, end);
        for (const auto &[points_per_length, published, requirement] :
             {std::make_tuple(1600u, Comparison::none, Requirement()),
              {3200u, 3.4e-5, Requirement::within(3.4e-5, 2e-6)},
              {6400u, Comparison::none, Requirement::at_most(1e-8)}})
          {
            const unsigned int n   = std::lround(2. * end * points_per_length);
            double             sum = 0.;
            for (unsigned int i = 0; i < n; ++i)
              sum += law(end * ((2. * i + 1.) / n - 1.), gap).g;
            comparison.add({"midpoint rule, " +
                              std::to_string(points_per_length) +
                              " points per length: error",
                            published,
                            std::abs(sum * 2. * end / n / exact - 1.),
                            requirement});
          }
      }

      /**
       * What a cutoff does to this force: where forces are left out, and where
       * the energy is switched off, whose slope attracts.
       */
      void
      add_cutoff_integrals()
      {
        const double diameter   = 2. * scene.fibers[0].radius;
        const auto   half_chord = [&](const double radius) {
          return std::sqrt(radius * radius - std::pow(diameter + gap, 2));
        };
        const double exact =
          DiskCylinder(potential(), sections(), {})(gap, 1.).g;
        for (const auto &[radius, published, requirement] :
             {std::make_tuple(.045, Comparison::none, Requirement()),
              {.05, 4e-4, Requirement::at_most(1e-3)},
              {.06, Comparison::none, Requirement()}})
          {
            std::ostringstream name;
            name << "straight fiber, cutoff radius " << radius << ": ";
            comparison.add(
              {name.str() + "force left out",
               published,
               1. - Rigid::force_of_fiber(law({}), gap, half_chord(radius)) /
                      exact,
               requirement});
            const OffsetDisks switched =
              law(Rigid::switched_off_at(radius, scene.fibers[0].radius));
            comparison.add(
              {name.str() + "force added with the energy switched off",
               Comparison::none,
               Rigid::force_of_fiber(switched,
                                     gap,
                                     half_chord(switched.cutoff() + diameter)) /
                   exact -
                 1.});
          }
      }

      SectionPair
      sections() const
      {
        return {scene.fibers[0].radius, scene.fibers[1].radius, 1., 1.};
      }

      PointPotential
      potential() const
      {
        const std::vector<double> &k = scene.interactions[0].prefactors;
        return {{6, k[0]}, {12, k[1]}};
      }

      OffsetDisks
      law(const GapRange &range) const
      {
        return {potential(), sections(), range};
      }

      /**
       * The offset along the axis of the source: the bias of Sec. 5.3, for
       * which the paper prints no number. Where the target bends away from the
       * source with the curvature 2 k relative to it, the axis of the source
       * sees a gap that is k q1^2/2 larger than that of the averaged one, at
       * both sides alike: the attraction is too weak, in proportion to the
       * curvature.
       */
      void
      add_arcs()
      {
        for (const double curvature : {.4, .8, 1.6})
          {
            std::ostringstream name;
            name << "axis of the source: force on arcs of curvature "
                 << curvature << ", relative";
            const auto force = [&](const OffsetAxis axis) {
              return Rigid::force_of_arcs(law({}),
                                          scene.fibers[0].radius,
                                          curvature,
                                          axis);
            };
            comparison.add(
              {name.str(),
               Comparison::none,
               force(OffsetAxis::source) / force(OffsetAxis::averaged),
               Requirement::within(1. - .0088 * curvature, 5e-4)});
          }
      }

      static constexpr double gap = 9e-4; // of the straight fiber

      const Scene scene;
      Comparison  comparison;
    };
  } // namespace Peeling
} // namespace Setae



int
main(int, char *argv[])
{
  try
    {
      return Setae::Peeling::IssipForces(argv[1]).run() ? 0 : 1;
    }
  catch (const std::exception &error)
    {
      std::cerr << error.what() << std::endl;
      return 1;
    }
}
