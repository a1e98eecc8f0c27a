// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_benchmarks_rigid_fibers_h
#define setae_benchmarks_rigid_fibers_h

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/minima.hpp>

#include <setae/interactions/offset_sections.h>
#include <setae/laws/offset_disks.h>

namespace Setae
{
  namespace Peeling
  {
    /** Forces of offset disks on fibers that are where they are. */
    namespace Rigid
    {
      /** The part of the cutoff over which interactions are switched off. */
      inline constexpr double switch_width = .1;

      /**
       * The cutoff by which the paper's @p radius about a section is in the
       * middle of the switch.
       */
      inline GapRange
      switched_off_at(const double radius, const double fiber_radius)
      {
        const double middle = radius - 2. * fiber_radius;
        GapRange     range;
        range.cutoff       = middle / (1. - .5 * switch_width);
        range.cutoff_begin = (1. - switch_width) * range.cutoff;
        return range;
      }



      /**
       * The force on a section at a gap from a straight fiber, of its part with
       * offsets of at most @p end.
       */
      inline double
      force_of_fiber(const OffsetDisks &law, const double gap, const double end)
      {
        return 2. *
               boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
                 [&](const double offset) { return law(offset, gap).g; },
                 0.,
                 end,
                 15,
                 1e-12);
      }



      /** The energy of two arcs that bend away from each other at @p gap. */
      inline double
      energy_of_arcs(const OffsetSections<OffsetDisks> &interaction,
                     const double                       radius,
                     const double                       curvature,
                     const double                       gap)
      {
        // Points closer than a third of the gap, and 30 gaps away from them and
        // 120 gaps away from the middle.
        using Vector             = Tensor<1, 3>;
        constexpr double       h = 2.5e-4;
        constexpr unsigned int n = 480, range = 120;

        const auto point = [&](const double side, const double s) {
          const double x = radius + .5 * (gap + curvature * s * s);
          return std::make_pair(Vector({side * x, s, 0.}),
                                Vector({side * curvature * s, 1., 0.}));
        };
        double sum = 0.;
        for (unsigned int i = 0; i <= 2 * n; ++i)
          for (unsigned int j = 0; j <= 2 * range; ++j)
            {
              const double s1     = h * (double(i) - n);
              const auto [r1, a1] = point(-1., s1);
              const auto [r2, a2] = point(1., s1 + h * (double(j) - range));
              sum += interaction.energy(r1, a1, r2, a2);
            }
        return sum * h * h;
      }



      /**
       * The largest force, over the gap, with which two equal arcs attract each
       * other.
       */
      inline double
      force_of_arcs(const OffsetDisks &law,
                    const double       radius,
                    const double       curvature,
                    const OffsetAxis   axis)
      {
        const OffsetSections<OffsetDisks> interaction(law,
                                                      2. * radius,
                                                      axis,
                                                      true);
        const auto                        minus_force = [&](const double gap) {
          constexpr double step = 1e-6;
          return (energy_of_arcs(interaction, radius, curvature, gap - step) -
                  energy_of_arcs(interaction, radius, curvature, gap + step)) /
                 (2. * step);
        };
        constexpr int bits = 12; // a maximum is flat
        return -boost::math::tools::brent_find_minima(minus_force,
                                                      8e-4,
                                                      1.2e-3,
                                                      bits)
                  .second;
      }
    } // namespace Rigid
  }   // namespace Peeling
} // namespace Setae

#endif
