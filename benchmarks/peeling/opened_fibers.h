// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_benchmarks_opened_fibers_h
#define setae_benchmarks_opened_fibers_h

#include <cmath>

#include "peeling_curve.h"

namespace Setae
{
  namespace Peeling
  {
    /**
     * The way to pull-off that does not peel: the fibers of peeling_issip.prm
     * begin half a length apart. Loads at their middles press them together
     * until t = 1, to a gap a bit below that of their equilibrium. There the
     * interaction is switched on until t = 2, which hardly moves them and so
     * passes no instability; the loads are taken off until t = 3, then the
     * supports move on. The equilibria from t = 3 on are those of the peeling
     * curve, for a tenth of the cost: the fibers never meet outside of their
     * middles.
     */
    namespace Opened
    {
      /** About the paper's 3200 points per length [1/length]. */
      inline constexpr unsigned int n_points = 16384;

      inline std::string
      scene(const std::string &peeling)
      {
        return peeling + R"(
subsection loads
  set names = left, right

  subsection left
    set fibers = left
    set at     = 2.5
    set force  = 0.0082243*min(1, t, 3 - min(t, 3)); 0; 0
  end

  subsection right
    set fibers = right
    set at     = 2.5
    set force  = -0.0082243*min(1, t, 3 - min(t, 3)); 0; 0
  end
end
)";
      }

      /** The supports are u_x/l = 0.5 + (t - 3)/10 apart. */
      inline double
      time(const double opening)
      {
        return 3. + 10. * (opening - .5);
      }

      /** Steps until an opening is reached, with @p n_cells cells a fiber. */
      inline Overrides
      until(const double opening, const unsigned int n_cells = 64)
      {
        std::ostringstream end_time;
        end_time << "load stepping/end time=" << time(opening);
        return cells(n_cells) +
               Overrides{"constants=l = 5, R = 0.02, g_0 = 2.5",
                         "supports/right/displacement="
                         "l*max(0, t - 3)/10; free; free",
                         "interactions/adhesion/strength=max(0, min(1, t - 1))",
                         "interactions/adhesion/integration segments=" +
                           std::to_string(n_points / n_cells),
                         "load stepping/first step=0.25",
                         "load stepping/instability resolution=1e-4",
                         end_time.str(),
                         // One step ends at u_x/l = 0.57, to compare there.
                         "load stepping/largest step=if(t < 1, 0.25, "
                         "if(t < 3.69, min(0.3, 3.7 - t), 0.02))"};
      }

      /** Without the points at which loads act. */
      inline Curve
      released(Curve curve)
      {
        const auto first =
          std::find_if(curve.points.begin(),
                       curve.points.end(),
                       [](const Point &p) { return p.time >= 3.; });
        curve.points.erase(curve.points.begin(), first);
        return curve;
      }



      /** Positions and curvatures of the left fiber, to see them converge. */
      class Shape
      {
      public:
        Shape() = default;

        explicit Shape(const FiberProblem &problem)
        {
          const FiberSystem &fibers = problem.fiber_system();
          const State        state  = problem.state();
          const double       length = fibers.scene.fibers[0].length;
          for (unsigned int i = 0; i < n_stations; ++i)
            {
              const auto [cell, x] =
                fibers.locate(0, (i + .5) / n_stations * length);
              const HermiteCell<> &r   = state.current[cell];
              const auto           r_x = r.derivative(x);
              positions.push_back(r.position(x));
              curvatures.push_back(
                dealii::cross_product_3d(r_x, r.second_derivative(x)) /
                std::pow(r_x.norm(), 3));
            }
        }

        /** L2 norms of the differences over those of the reference. */
        double
        position_error(const Shape &reference) const
        {
          return relative(positions, reference.positions);
        }

        double
        curvature_error(const Shape &reference) const
        {
          return relative(curvatures, reference.curvatures);
        }

      private:
        using Field = std::vector<dealii::Tensor<1, 3>>;

        // Not a multiple of the cells, so none of their points is preferred.
        static constexpr unsigned int n_stations = 9973;

        static double
        relative(const Field &field, const Field &reference)
        {
          double difference = 0., norm = 0.;
          for (unsigned int i = 0; i < n_stations; ++i)
            {
              difference += (field[i] - reference[i]).norm_square();
              norm += reference[i].norm_square();
            }
          return std::sqrt(difference / norm);
        }

        Field positions, curvatures;
      };
    } // namespace Opened
  }   // namespace Peeling
} // namespace Setae

#endif
