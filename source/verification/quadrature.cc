// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <setae/base/exceptions.h>
#include <setae/verification/quadrature.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <sstream>

namespace Setae
{
  namespace References
  {
    namespace
    {
      constexpr std::size_t max_n_intervals = 300;

      /** GSL reports by return values instead of ending the program. */
      class NoErrorHandler
      {
      public:
        NoErrorHandler()
          : previous(gsl_set_error_handler_off())
        {}

        ~NoErrorHandler()
        {
          gsl_set_error_handler(previous);
        }

        NoErrorHandler(const NoErrorHandler &) = delete;
        NoErrorHandler &
        operator=(const NoErrorHandler &) = delete;

      private:
        gsl_error_handler_t *previous;
      };



      /** Keeps exceptions of the integrand from passing through C. */
      struct Guarded
      {
        const Function    &f;
        std::exception_ptr exception = nullptr;

        static double
        call(double x, void *self)
        {
          auto &guarded = *static_cast<Guarded *>(self);
          if (guarded.exception)
            return 0.;
          try
            {
              return guarded.f(x);
            }
          catch (...)
            {
              guarded.exception = std::current_exception();
              return 0.;
            }
        }
      };
    } // namespace



    Estimate
    operator*(const double factor, const Estimate &estimate)
    {
      return {factor * estimate.value, std::abs(factor) * estimate.error};
    }



    Estimate
    operator+(const Estimate &a, const Estimate &b)
    {
      return {a.value + b.value, a.error + b.error};
    }



    EnergyAndForce
    operator*(const double factor, const EnergyAndForce &pair)
    {
      return {factor * pair.energy, factor * pair.force};
    }



    EnergyAndForce
    operator+(const EnergyAndForce &a, const EnergyAndForce &b)
    {
      return {a.energy + b.energy, a.force + b.force};
    }



    Estimate
    integrate(const Function &f,
              const double    a,
              const double    b,
              const double    tolerance,
              const double    negligible)
    {
      const NoErrorHandler no_error_handler;
      const std::unique_ptr<gsl_integration_workspace,
                            decltype(&gsl_integration_workspace_free)>
        workspace(gsl_integration_workspace_alloc(max_n_intervals),
                  &gsl_integration_workspace_free);

      Guarded            guarded{f};
      const gsl_function function = {&Guarded::call, &guarded};
      Estimate           result;
      const int          status = gsl_integration_qag(&function,
                                             a,
                                             b,
                                             negligible,
                                             tolerance,
                                             max_n_intervals,
                                             GSL_INTEG_GAUSS41,
                                             workspace.get(),
                                             &result.value,
                                             &result.error);
      if (guarded.exception)
        std::rethrow_exception(guarded.exception);
      if (status == GSL_SUCCESS && std::isfinite(result.value))
        return result;

      std::ostringstream message;
      message << "An integral of a reference, " << result.value
              << " with an estimated error of " << result.error
              << ", did not reach the relative tolerance " << tolerance << " ("
              << gsl_strerror(status) << ").";
      AssertThrow(false, ExcRun(message.str()));
      return result;
    }



    Estimate
    integrate_peak(const Function &f,
                   const double    a,
                   const double    b,
                   const double    peak,
                   const double    scale,
                   const double    tolerance,
                   const double    far,
                   const double    negligible)
    {
      const auto substituted = [&](const double u) {
        return f(peak + scale * std::sinh(u)) * scale * std::cosh(u);
      };
      const auto between = [&](const double begin, const double end) {
        // Seen from far away a peak is smooth, and the difference of two large
        // u would be noise.
        const double away = std::max(begin - peak, peak - end);
        if (away > end - begin)
          return integrate(f, begin, end, tolerance, negligible);
        return integrate(substituted,
                         std::asinh((begin - peak) / scale),
                         std::asinh((end - peak) / scale),
                         tolerance,
                         negligible);
      };
      const auto tail = [&](const double begin, const double sign) {
        const double length = sign * (begin - peak);
        return integrate(
          [&](const double y) {
            const double distance = length / (y * y);
            return f(peak + sign * distance) * 2. * distance / y;
          },
          0.,
          1.,
          tolerance,
          negligible);
      };

      const double begin = std::isinf(a) ? std::min(peak, b) - far : a;
      const double end   = std::isinf(b) ? std::max(peak, a) + far : b;
      Estimate     sum   = between(begin, end);
      if (std::isinf(a))
        sum = sum + tail(begin, -1.);
      if (std::isinf(b))
        sum = sum + tail(end, 1.);
      return sum;
    }
  } // namespace References
} // namespace Setae
