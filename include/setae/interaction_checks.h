// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_interaction_checks_h
#define setae_interaction_checks_h

#include <setae/scene.h>

namespace Setae
{
  /**
   * Check that the parameters of an interaction, with the integrator of the
   * scene, fit its law and each other. The fibers that it names are not looked
   * at.
   *
   * @throws ExcParameter with the first parameter that does not.
   */
  void
  check_interaction(const InteractionParameters &interaction,
                    const DynamicsParameters    &dynamics);
} // namespace Setae

#endif
