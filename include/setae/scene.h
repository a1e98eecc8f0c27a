// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#ifndef setae_scene_h
#define setae_scene_h

#include <setae/base/expression.h>

#include <string>
#include <vector>

namespace Setae
{
  class Entries;

  /** One named subsection: a fiber, or an array of equal ones. */
  struct FiberParameters
  {
    std::string               name;
    std::string               centerline = "s; 0; 0";
    std::string               mesh_file;
    std::vector<unsigned int> copies           = {1};
    double                    length           = 1.;
    double                    radius           = .01;
    double                    youngs_modulus   = 1.;
    double                    poisson_ratio    = .3;
    unsigned int              n_cells          = 16;
    double                    number_density   = 1.;
    double                    surface_density  = 1.;
    double                    density          = 0.;
    std::string               initial_velocity = "0; 0; 0";
    std::string               beam;
    double                    largest_kink = 10.;

    /** The numbers i, j, k of each copy, i running slowest. */
    std::vector<Constants>
    copy_indices() const;

    /**
     * The parameters of one copy, whose numbers may be formulas of its i, j, k.
     *
     * @throws ExcParameter if a number of the copy cannot be used.
     */
    FiberParameters
    of_copy(const Constants &constants, const Constants &copy) const;

    /** The numbers of the section as they are written. */
    std::map<std::string, std::string> texts;

    void
    add_parameters(Entries &prm);
  };



  /** One named subsection: what is held or moved, and how. */
  struct SupportParameters
  {
    std::string              name;
    std::vector<std::string> fibers            = {"all"};
    std::string              copies            = "all";
    std::vector<std::string> at                = {"start"};
    std::string              displacement      = "free; free; free";
    std::string              tangent           = "free; free; free";
    std::string              tangent_direction = "free";

    void
    add_parameters(Entries &prm);
  };



  /** One named subsection: forces and moments on fibers. */
  struct LoadParameters
  {
    std::string              name;
    std::vector<std::string> fibers = {"all"};
    std::string              copies = "all";
    std::vector<std::string> at     = {"end"};
    std::string              force  = "0; 0; 0";
    std::string              moment = "0; 0; 0";

    void
    add_parameters(Entries &prm);
  };



  /** One named subsection: a potential between the points of two groups. */
  struct InteractionParameters
  {
    std::string               name;
    std::string               law;
    std::string               target_ends          = "by law";
    std::vector<std::string>  source               = {"all"};
    std::vector<std::string>  target               = {"all"};
    bool                      two_half_passes      = false;
    bool                      self_interaction     = false;
    unsigned int              n_excluded_neighbors = 2;
    std::vector<unsigned int> exponents            = {6, 12};
    std::vector<double>       prefactors;
    std::string               distribution          = "volume";
    std::string               strength              = "1";
    double                    penalty               = 0.;
    double                    equilibrium_gap       = 0.;
    double                    force_minimum         = 0.;
    double                    hamaker_constant      = 0.;
    double                    cutoff                = 0.;
    double                    switch_width          = .1;
    std::string               cutoff_of             = "energy";
    double                    regularization        = 0.;
    double                    skin                  = 0.;
    double                    far_field_tolerance   = 0.;
    std::string               integration_rule      = "gauss";
    unsigned int              n_segments            = 2;
    unsigned int              n_gauss_points        = 10;
    double                    integration_tolerance = 1e-4;
    std::string               frame                 = "averaged";
    bool                      interaction_moments   = true;
    std::vector<unsigned int> section_points        = {4, 9};
    double                    law_tolerance         = 5e-4;

    /** Whether the forces are the derivatives of the energy. */
    bool
    has_potential() const
    {
      return interaction_moments && cutoff_of == "energy";
    }

    void
    add_parameters(Entries &prm);
  };



  /** How the load is applied. */
  struct LoadSteppingParameters
  {
    double       end_time               = 1.;
    double       first_step             = .1;
    std::string  largest_step           = "1";
    double       smallest_step          = 0.;
    double       instability_resolution = 1e-4;
    double       growth                 = 4.;
    unsigned int target_n_iterations    = 20;
    bool         pass_instabilities     = true;

    void
    add_parameters(Entries &prm);
  };



  /** Whether the fibers have inertia, and how their motion is integrated. */
  struct DynamicsParameters
  {
    std::string  integrator           = "none";
    double       end_time             = 1.;
    double       time_step            = 1e-3;
    double       tolerance            = 0.;
    double       largest_step         = 0.;
    double       smallest_step        = 0.;
    double       largest_displacement = 0.;
    double       energy_tolerance     = 0.;
    double       largest_energy_gain  = 1e-3;
    double       rho_infinity         = .9;
    double       damping              = 0.;
    unsigned int max_order            = 2;

    /** Otherwise the scene is static. */
    bool
    is_on() const
    {
      return integrator != "none";
    }

    /** What a step may not be shorter than [time]. */
    double
    shortest_step() const
    {
      return smallest_step > 0. ? smallest_step : 1e-6 * time_step;
    }

    /** @throws ExcParameter if they do not fit each other or the fibers. */
    void
    check(const std::vector<FiberParameters> &fibers) const;

    void
    add_parameters(Entries &prm);
  };



  /** How the equilibrium of one load step is found. */
  struct NewtonParameters
  {
    double       relative_residual_tolerance  = 1e-7;
    double       relative_increment_tolerance = 1e-7;
    double       residual_tolerance           = 0.;
    double       increment_tolerance          = 0.;
    unsigned int max_n_iterations             = 30;
    double       largest_increment            = 0.;
    std::string  linear_solver                = "Amesos_Klu";
    bool         log_iterations               = false;

    void
    add_parameters(Entries &prm);
  };



  /** What is written, and how often. */
  struct OutputParameters
  {
    std::string  directory;
    double       interval       = 0.;
    unsigned int n_subdivisions = 4;
    bool         fields         = true;

    void
    add_parameters(Entries &prm);
  };



  /** How accurate a full quadrature has to be, and what it may cost. */
  struct FullQuadratureParameters
  {
    double       tolerance    = 1e-3;
    double       separation   = .7;
    unsigned int max_n_points = 8;
    double       max_n_pairs  = 1e11;
    double       max_n_cells  = 1e6;

    void
    add_parameters(Entries &prm);
  };



  /**
   * All that a .prm file says. Read once, constant from then on.
   */
  struct Scene
  {
    std::string title;
    std::string coordinates = "x, y, z";
    Constants   constants;

    std::vector<FiberParameters>       fibers;
    std::vector<SupportParameters>     supports;
    std::vector<LoadParameters>        loads;
    std::vector<InteractionParameters> interactions;
    LoadSteppingParameters             load_stepping;
    DynamicsParameters                 dynamics;
    NewtonParameters                   newton;
    OutputParameters                   output;
    std::string                        verification = "none";
    FullQuadratureParameters           full_quadrature;

    /** Everything as it is used, as a .prm file that repeats the run. */
    std::string used_parameters;

    /**
     * @throws ExcParameter with the first parameter whose value cannot be used.
     */
    void
    check() const;

    /** Those of every fiber whose parameters can differ from another's. */
    std::vector<FiberParameters>
    parameters_of_copies() const;

    /** Whether fibers may overlap a little because a contact force acts. */
    bool
    has_contact() const;

    /** The time at which the run is over, of load steps or of a motion. */
    double
    end_time() const
    {
      return dynamics.is_on() ? dynamics.end_time : load_stepping.end_time;
    }

    /** The indices 0, 1, 2 of the coordinates that are not switched off. */
    std::vector<unsigned int>
    active_coordinates() const;

    /**
     * Read a scene.
     *
     * @param file_text The contents of a .prm file.
     * @param file_name Its name, for messages and for the default directory.
     * @param overrides "section/name=value", applied after the file.
     *
     * @throws ExcInput, ExcParameter with one sentence on the first entry that
     * cannot be used.
     */
    static Scene
    read(const std::string              &file_text,
         const std::string              &file_name,
         const std::vector<std::string> &overrides = {});

    /**
     * Every parameter with default, allowed values and documentation, as a .prm
     * file with one fiber, support, load and interaction.
     */
    static std::string
    documentation();
  };
} // namespace Setae

#endif
