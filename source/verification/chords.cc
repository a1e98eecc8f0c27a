// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>

#include <setae/base/exceptions.h>
#include <setae/verification/chords.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Setae
{
  namespace References
  {
    using dealii::Tensor;

    namespace
    {
      constexpr double pi = M_PI;

      /** Where a function with one minimum has it, exactly if at an end. */
      double
      argument_of_minimum(const Function &f, const double a, const double b)
      {
        constexpr int half_of_the_digits = 26;

        const auto inside =
          boost::math::tools::brent_find_minima(f, a, b, half_of_the_digits);
        for (const double end : {a, b})
          if (f(end) <= inside.second)
            return end;
        return inside.first;
      }



      double
      root(const Function &f, const double a, const double b)
      {
        std::uintmax_t max_n_iterations = 100;
        const auto     bracket          = boost::math::tools::toms748_solve(
          f,
          a,
          b,
          boost::math::tools::eps_tolerance<double>(40),
          max_n_iterations);
        return .5 * (bracket.first + bracket.second);
      }
    } // namespace



    Chords::Chords(const double radius, const double angle_)
      : R(radius)
      , angle(std::min(.5 * pi, std::max(-.5 * pi, angle_)))
      , sine(std::sin(angle))
      , cosine(std::abs(angle) < .5 * pi ? std::cos(angle) : 0.)
    {}



    Chords
    Chords::seen_from(const double turn) const
    {
      return Chords(R, angle + turn);
    }



    double
    Chords::radius() const
    {
      return R;
    }



    double
    Chords::first_turn() const
    {
      return -.5 * pi - angle;
    }



    double
    Chords::last_turn() const
    {
      return .5 * pi - angle;
    }



    double
    Chords::half_length(const double turn) const
    {
      return R * (cosine * std::cos(turn) - sine * std::sin(turn));
    }



    double
    Chords::from_center(const double turn) const
    {
      return R * (sine * std::cos(turn) + cosine * std::sin(turn));
    }



    double
    Chords::step(const double turn) const
    {
      const double half = .5 * turn;
      return 2. * R * std::sin(half) *
             (cosine * std::cos(half) - sine * std::sin(half));
    }



    double
    Chords::retreat(const double turn) const
    {
      const double half = .5 * turn;
      return 2. * R * std::sin(half) *
             (sine * std::cos(half) + cosine * std::sin(half));
    }



    double
    PairOfChords::smallest_distance() const
    {
      return std::hypot(distance, std::max(0., points.rise.begin));
    }



    PairsOfChords::PairsOfChords(const SectionPair &sections,
                                 const Disk        &disk_1,
                                 const Disk        &disk_2)
      : first(sections.radius_1)
      , second(sections.radius_2)
    {
      find_axes(disk_1, disk_2);

      const Tensor<1, 3> d = disk_1.center - disk_2.center;
      height               = d * normal;
      sideways             = d * lateral;
      gap                  = d * along - sections.radius_1 - sections.radius_2;

      const Tensor<1, 3> step = dealii::cross_product_3d(disk_1.normal, along);
      rise                    = step * normal;
      run                     = step * lateral;

      *this = row(argument_of_minimum(
        [&](const double turn_1) {
          return row(turn_1).pair(0., 0.).smallest_distance();
        },
        first.first_turn(),
        first.last_turn()));
      AssertThrow(pair(0., 0.).smallest_distance() > 0.,
                  ExcRun("The disks touch."));
    }



    void
    PairsOfChords::find_axes(const Disk &disk_1, const Disk &disk_2)
    {
      constexpr double round_off = 1e-14;

      // Parallel planes have many common directions: of these the one that is
      // normal to the connection of the centers, or any if there is none.
      const Tensor<1, 3>  d = disk_1.center - disk_2.center;
      const Tensor<1, 3> &n = disk_1.normal;
      along                 = dealii::cross_product_3d(n, disk_2.normal);
      if (along.norm() < round_off)
        along = dealii::cross_product_3d(n, d) / d.norm();
      if (along.norm() < round_off)
        along = dealii::cross_product_3d(n,
                                         std::abs(n[0]) < .7 ?
                                           Tensor<1, 3>({1., 0., 0.}) :
                                           Tensor<1, 3>({0., 1., 0.}));
      // The difference of two almost equal normals has few digits.
      along -= (along * n) * n;
      along /= (along * d < 0. ? -1. : 1.) * along.norm();

      normal  = disk_2.normal;
      lateral = dealii::cross_product_3d(normal, along);
    }



    PairsOfChords
    PairsOfChords::seen_from(const double turn_1, const double turn_2) const
    {
      const double  step   = first.step(turn_1);
      PairsOfChords result = *this;
      result.first         = first.seen_from(turn_1);
      result.second        = second.seen_from(turn_2);
      result.height        = height + rise * step;
      result.sideways      = sideways + run * step - second.step(turn_2);
      result.gap = gap + first.retreat(turn_1) + second.retreat(turn_2);
      return result;
    }



    PairsOfChords
    PairsOfChords::row(const double turn_1) const
    {
      return seen_from(turn_1,
                       argument_of_minimum(
                         [&](const double turn_2) {
                           return pair(turn_1, turn_2).smallest_distance();
                         },
                         second.first_turn(),
                         second.last_turn()));
    }



    PairOfChords
    PairsOfChords::pair(const double turn_1, const double turn_2) const
    {
      const double step   = first.step(turn_1);
      const double h      = height + rise * step;
      const double half_1 = first.half_length(turn_1),
                   half_2 = second.half_length(turn_2);
      return {h,
              std::hypot(h, sideways + run * step - second.step(turn_2)),
              half_1,
              half_2,
              second.from_center(turn_2),
              PairMeasure(gap + first.retreat(turn_1) + second.retreat(turn_2),
                          half_1,
                          half_2)};
    }



    std::vector<double>
    PairsOfChords::crossing_edges() const
    {
      const double R2 = second.radius();
      const double offset =
        gap + first.half_length(0.) + second.half_length(0.);

      // Of a chord and the one below it the distances of begin and end from
      // end and begin, from begin and from end, and those of the chord from
      // both tips of the second disk.
      const auto distances = [&](const double turn) {
        const double x =
          second.from_center(0.) + sideways + run * first.step(turn);
        const double half_1 = first.half_length(turn);
        const double half_2 = std::sqrt(std::max(0., (R2 - x) * (R2 + x)));
        return std::array<double, 5>{{offset - half_1 - half_2,
                                      offset + half_1 - half_2,
                                      offset - half_1 + half_2,
                                      x - R2,
                                      x + R2}};
      };

      constexpr unsigned int n       = 200;
      const double           gradual = .1 * pair(0., 0.).smallest_distance();
      const auto             turn    = [&](const unsigned int i) {
        return first.first_turn() + i * pi / n;
      };
      std::vector<double> turns;
      auto                before = distances(turn(0));
      for (unsigned int i = 1; i <= n; ++i)
        {
          const auto after = distances(turn(i));
          for (unsigned int k = 0; k < after.size(); ++k)
            if (before[k] * after[k] < 0. &&
                std::abs(after[k] - before[k]) > gradual)
              turns.push_back(
                root([&](const double turn) { return distances(turn)[k]; },
                     turn(i - 1),
                     turn(i)));
          before = after;
        }
      return turns;
    }
  } // namespace References
} // namespace Setae
