// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/assembly/interaction.h>
#include <setae/scene.h>
#include <setae/verification/calibration.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <set>
#include <tuple>

namespace Setae
{
  namespace References
  {
    namespace
    {
      bool
      contains(const std::vector<std::string> &names, const std::string &name)
      {
        return std::any_of(names.begin(), names.end(), [&](const auto &n) {
          return n == name || n == "all";
        });
      }



      void
      print_prefactors(const std::vector<FittedPrefactor> &fitted,
                       std::ostream                       &out)
      {
        out << "  exponent      factor   fitted prefactor\n";
        for (const FittedPrefactor &f : fitted)
          out << std::setw(10) << f.exponent << std::fixed
              << std::setprecision(6) << std::setw(12) << f.factor
              << std::scientific << std::setprecision(10) << std::setw(19)
              << f.prefactor << '\n';
      }



      /** Errors of every power at one gap, in percent. */
      void
      print_errors_at(const std::string                  &law,
                      const std::vector<FittedPrefactor> &fitted,
                      const StraightFibers               &fibers,
                      const double                        gap,
                      std::ostream                       &out)
      {
        out << std::scientific << std::setprecision(3) << std::setw(14) << gap
            << std::fixed;
        for (const FittedPrefactor &f : fitted)
          {
            const EnergyAndForce truth = exact({f.exponent, 1.}, fibers, gap);
            const EnergyAndForce model =
              by_law(law, {f.exponent, f.factor}, fibers, gap);
            const auto percent = [](const Estimate &a, const Estimate &b) {
              const double error = 100. * (a.value / b.value - 1.);
              return std::abs(error) < 5e-4 ? 0. : error;
            };
            out << std::setw(13) << percent(model.energy, truth.energy)
                << std::setw(13) << percent(model.force, truth.force);
          }
        out << '\n';
      }



      void
      print_errors(const std::string                  &law,
                   const std::vector<FittedPrefactor> &fitted,
                   const StraightFibers               &fibers,
                   const double                        fitted_gap,
                   std::ostream                       &out)
      {
        out << "  Error that remains in percent:\n           gap";
        for (const FittedPrefactor &f : fitted)
          out << std::setw(13) << "energy m=" + std::to_string(f.exponent)
              << std::setw(13) << "force m=" + std::to_string(f.exponent);
        out << '\n';
        for (const double factor : {.1, .2, .5, 1., 2., 5., 10.})
          print_errors_at(law, fitted, fibers, factor * fitted_gap, out);
      }
    } // namespace



    void
    calibrate(const Scene  &scene,
              const double  gap,
              const double  angle,
              std::ostream &out)
    {
      const std::vector<FiberParameters> copies = scene.parameters_of_copies();
      for (const InteractionParameters &interaction : scene.interactions)
        {
          if (interaction.penalty > 0.)
            continue;
          std::set<std::tuple<double, double, double, double>> seen;
          for (const FiberParameters &source : copies)
            for (const FiberParameters &target : copies)
              {
                const SectionPair pair =
                  section_pair(interaction, source, target);
                if (!contains(interaction.source, source.name) ||
                    !contains(interaction.target, target.name) ||
                    !seen
                       .emplace(pair.radius_1,
                                pair.radius_2,
                                pair.density_1,
                                pair.density_2)
                       .second)
                  continue;
                const StraightFibers fibers{pair, angle};
                const auto           fitted = fit(interaction.law,
                                        point_potential(interaction, pair),
                                        fibers,
                                        gap);

                out << "interaction '" << interaction.name << "', law "
                    << interaction.law << ", source '" << source.name
                    << "', target '" << target.name << "':\n  ";
                if (angle == 0.)
                  out << "parallel fibers";
                else
                  out << "fibers crossing at " << angle * 180. / M_PI
                      << " degrees";
                out << ", force fitted at the gap " << gap << '\n';
                print_prefactors(fitted, out);
                print_errors(interaction.law, fitted, fibers, gap, out);
                out << std::defaultfloat << std::setprecision(6);
              }
        }
    }
  } // namespace References
} // namespace Setae
