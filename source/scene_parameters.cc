// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <setae/base/entries.h>
#include <setae/base/entry_patterns.h>
#include <setae/base/exceptions.h>
#include <setae/beams/all.h>
#include <setae/scene.h>

#include <algorithm>

namespace Setae
{
  using namespace dealii;
  using namespace EntryPatterns;



  std::vector<Constants>
  FiberParameters::copy_indices() const
  {
    std::array<unsigned int, 3> n = {{1, 1, 1}};
    std::copy(copies.begin(), copies.end(), n.begin());

    std::vector<Constants> result;
    for (unsigned int i = 0; i < n[0]; ++i)
      for (unsigned int j = 0; j < n[1]; ++j)
        for (unsigned int k = 0; k < n[2]; ++k)
          result.push_back(
            {{"i", double(i)}, {"j", double(j)}, {"k", double(k)}});
    return result;
  }



  FiberParameters
  FiberParameters::of_copy(const Constants &constants,
                           const Constants &copy) const
  {
    FiberParameters result = *this;
    if (std::none_of(texts.begin(), texts.end(), [](const auto &number) {
          return depends_on_copy(number.second);
        }))
      return result;

    Entries prm;
    prm.constants = with_copy(constants, copy);
    result.add_parameters(prm);
    for (const auto &[entry, text] : texts)
      try
        {
          prm.set(entry, text);
        }
      catch (const ParameterHandler::ExcValueDoesNotMatchPattern &)
        {
          AssertThrow(
            false,
            ExcParameter("fibers/" + name + "/" + entry,
                         text,
                         "a number that is allowed in every copy, "
                         "but is not for i = " +
                           std::to_string(int(copy.at("i"))) +
                           ", j = " + std::to_string(int(copy.at("j"))) +
                           ", k = " + std::to_string(int(copy.at("k")))));
        }
    return result;
  }



  void
  FiberParameters::add_parameters(Entries &prm)
  {
    prm.add_parameter("centerline",
                      centerline,
                      "The initial centerline x; y; z [length] as formulas of "
                      "s in [0, length] and of the numbers i, j, k of the copy "
                      "(from 0). Any regular parameter s will do; derivatives "
                      "are taken numerically, from values within that range. A "
                      "curve that comes back to its start in the direction in "
                      "which it began is a ring.",
                      Patterns::Anything());
    prm.add_parameter("mesh file",
                      mesh_file,
                      "A mesh of lines in space to read the centerlines from: "
                      "a legacy VTK file in ASCII with lines or polylines, or "
                      "a format that deal.II's GridIn knows by its extension "
                      "(msh, inp, ...). A relative path starts from the folder "
                      "of the scene, or else from the working directory. Each "
                      "connected chain of lines becomes a fiber, with its "
                      "number from 0 as i; nodes at the same place are joined. "
                      "'centerline', 'length', 'cells' and 'copies' are then "
                      "not used.",
                      Patterns::Anything());
    prm.add_parameter("largest kink",
                      largest_kink,
                      "For a mesh file: the largest change of direction from "
                      "one line to the next, beyond that at the neighbouring "
                      "nodes, that is smoothed [degrees]. More is refused as a "
                      "kink, as is any change by more than 60 degrees.",
                      Patterns::Double(0., 180.));
    prm.add_parameter("copies",
                      copies,
                      "The size of an array of equal fibers, up to three "
                      "numbers: '4, 5' makes 20 fibers with i = 0..3 and "
                      "j = 0..4 in their centerlines.",
                      Patterns::List(positive_integer(), 1, 3));
    prm.add_parameter("length",
                      length,
                      "The end of the range of s [length], positive.",
                      non_negative());
    prm.add_parameter("radius",
                      radius,
                      "Radius of the circular section [length], positive.",
                      non_negative());
    prm.add_parameter("youngs modulus",
                      youngs_modulus,
                      "Young's modulus [force/length^2], positive.",
                      non_negative());
    prm.add_parameter("poisson ratio",
                      poisson_ratio,
                      "Poisson's ratio. A shear-rigid fiber without torsion "
                      "does not depend on it.",
                      Patterns::Double());
    prm.add_parameter("cells",
                      n_cells,
                      "The number of equal cells along s.",
                      positive_integer());
    prm.add_parameter("number density",
                      number_density,
                      "Points of the interaction potential per volume "
                      "[1/length^3].",
                      non_negative());
    prm.add_parameter("surface density",
                      surface_density,
                      "Points of the interaction potential per area of the "
                      "lateral surface, or their charge, of either sign "
                      "[1/length^2].",
                      Patterns::Double());
    prm.add_parameter("density",
                      density,
                      "Mass per volume [mass/length^3], positive in a scene "
                      "with dynamics; statics does not use it.",
                      non_negative());
    prm.add_parameter("initial velocity",
                      initial_velocity,
                      "The velocity at time 0 in a scene with dynamics, "
                      "x; y; z, as formulas of the arc length s and of the "
                      "numbers i, j, k of the copy [length/time].",
                      Patterns::Anything());
    if (beam.empty())
      beam = TorsionFreeKirchhoff::name;
    prm.add_parameter("beam",
                      beam,
                      "The beam formulation. " + Beams::descriptions() + ".",
                      Patterns::Selection(Beams::names()));
  }



  void
  SupportParameters::add_parameters(Entries &prm)
  {
    prm.add_parameter("fibers",
                      fibers,
                      "The fibers that are supported, by name, or 'all'.",
                      names());
    prm.add_parameter("copies",
                      copies,
                      "Which copies of an array, or chains of a mesh file, of "
                      "these fibers: 'all', or a condition in their numbers "
                      "i, j, k such as 'i == 0 && j < 3'.",
                      Patterns::Anything());
    prm.add_parameter("at",
                      at,
                      "Where: 'start', 'end', 'all' (every node) or a formula "
                      "for the arc length s of a node [length].",
                      names());
    prm.add_parameter("displacement",
                      displacement,
                      "The displacement of the points from where they were "
                      "initially, x; y; z, each 'free' or a formula of the "
                      "time t and of the numbers i, j, k of the copy [length].",
                      Patterns::Anything());
    prm.add_parameter("tangent",
                      tangent,
                      "The change of the unit tangents from what they were "
                      "initially, x; y; z, each 'free' or a formula of t and "
                      "of i, j, k. All three prescribe the stretch of the "
                      "fiber there, too, and must leave a vector of length 1.",
                      Patterns::Anything());
    prm.add_parameter("tangent direction",
                      tangent_direction,
                      "A clamp that leaves the stretch of the fiber free: "
                      "'free', 'initial' for the direction that the tangent "
                      "has initially, or in a static scene a vector x; y; z "
                      "of any length as formulas of t and of i, j, k.",
                      Patterns::Anything());
  }



  void
  LoadParameters::add_parameters(Entries &prm)
  {
    prm.add_parameter("fibers",
                      fibers,
                      "The fibers that are loaded, by name, or 'all'.",
                      names());
    prm.add_parameter("copies",
                      copies,
                      "Which copies of an array, or chains of a mesh file, of "
                      "these fibers: 'all', or a condition in their numbers "
                      "i, j, k such as 'i == 0 && j < 3'.",
                      Patterns::Anything());
    prm.add_parameter("at",
                      at,
                      "Where: 'start', 'end' or a formula for an arc length s "
                      "for a point load, 'all' for a line load.",
                      names());
    prm.add_parameter(
      "force",
      force,
      "A dead load x; y; z as formulas of s, t and of the numbers i, j, k of "
      "the copy: a force at a point [force], or per initial length "
      "[force/length].",
      Patterns::Anything());
    prm.add_parameter(
      "moment",
      moment,
      "A moment x; y; z about axes fixed in space, as formulas "
      "of s, t, i, j, k, at a point [force length] or per initial "
      "length [force]. Its part along the tangent does no work "
      "on a fiber without torsion.",
      Patterns::Anything());
  }



  void
  LoadSteppingParameters::add_parameters(Entries &prm)
  {
    prm.add_parameter("end time",
                      end_time,
                      "The load goes from time 0 to this one.",
                      non_negative());
    prm.add_parameter("first step",
                      first_step,
                      "The first load step [time].",
                      non_negative());
    prm.add_parameter("largest step",
                      largest_step,
                      "The largest load step [time], a formula of t: small "
                      "where a peak of the curve has to be resolved. At no "
                      "time below the smallest step.",
                      Patterns::Anything());
    prm.add_parameter("smallest step",
                      smallest_step,
                      "No step is shorter, whatever the iterations or the "
                      "largest step ask for [time]; at most the first step. 0 "
                      "takes 1e-6 of the end time, or the first step or the "
                      "instability resolution if one of these is smaller.",
                      non_negative());
    prm.add_parameter("instability resolution",
                      instability_resolution,
                      "How finely the end of a branch of equilibria is located "
                      "[time]: a step that cannot be solved is repeated with "
                      "smaller size down to this one; a step of at most this "
                      "size that fails has met an instability. At least the "
                      "smallest step.",
                      non_negative());
    prm.add_parameter("growth",
                      growth,
                      "Largest factor from one step to the next.",
                      Patterns::Double(1.));
    prm.add_parameter("target iterations",
                      target_n_iterations,
                      "A step that takes more iterations than this one is "
                      "followed by a smaller one.",
                      positive_integer());
    prm.add_parameter(
      "pass instabilities",
      pass_instabilities,
      "Where no equilibrium is found within the instability "
      "resolution, follow the overdamped motion to the next stable state "
      "instead of stopping.");
  }



  void
  NewtonParameters::add_parameters(Entries &prm)
  {
    prm.add_parameter("relative residual tolerance",
                      relative_residual_tolerance,
                      "Largest norm of the residual relative to the forces of "
                      "all cells and pairs, and to what bends the softest "
                      "fiber, EI/length^2; positive. Where round-off of stiff "
                      "fibers leaves more, that counts.",
                      non_negative());
    prm.add_parameter("relative increment tolerance",
                      relative_increment_tolerance,
                      "Largest norm of the last increment relative to the "
                      "smallest radius; positive.",
                      non_negative());
    prm.add_parameter("residual tolerance",
                      residual_tolerance,
                      "Instead of the relative one, the largest Euclidean norm "
                      "of the residual, moments being divided by the length of "
                      "their cell [force]; 0 takes the relative one.",
                      non_negative());
    prm.add_parameter("increment tolerance",
                      increment_tolerance,
                      "Instead of the relative one, the largest Euclidean norm "
                      "of the last increment, changes of tangents being "
                      "multiplied by the length of their cell [length]; 0 "
                      "takes the relative one.",
                      non_negative());
    prm.add_parameter("iterations",
                      max_n_iterations,
                      "Largest number of iterations of one load step.",
                      positive_integer());
    prm.add_parameter("largest increment",
                      largest_increment,
                      "Largest displacement of a node by one correction "
                      "[length]; 0 means no bound.",
                      non_negative());
    prm.add_parameter("linear solver",
                      linear_solver,
                      "The direct solver of Trilinos' Amesos.",
                      Patterns::Selection("Amesos_Klu|Amesos_Mumps"));
    prm.add_parameter("log iterations",
                      log_iterations,
                      "Print a line for every iteration.");
  }



  void
  OutputParameters::add_parameters(Entries &prm)
  {
    prm.add_parameter("directory",
                      directory,
                      "Where results are written; empty takes 'output-' and "
                      "the name of the .prm file.",
                      Patterns::Anything());
    prm.add_parameter("fields",
                      fields,
                      "Write fibers and interaction forces for ParaView.");
    prm.add_parameter("interval",
                      interval,
                      "Time between two outputs of fields; 0 writes every load "
                      "step.",
                      non_negative());
    prm.add_parameter("subdivisions",
                      n_subdivisions,
                      "Lines that a cell is drawn with.",
                      positive_integer());
  }



  void
  FullQuadratureParameters::add_parameters(Entries &prm)
  {
    prm.add_parameter(
      "tolerance",
      tolerance,
      "Gauss points are added until the energy changes by less, "
      "relative to itself; positive.",
      non_negative());
    prm.add_parameter("separation",
                      separation,
                      "Cells are refined until all pairs of the two bodies are "
                      "apart by this multiple of their size; positive. Smaller "
                      "means less cells with more Gauss points.",
                      non_negative());
    prm.add_parameter(
      "gauss points",
      max_n_points,
      "At most so many in each direction of a cell, at least 3.",
      Patterns::Integer(3));
    prm.add_parameter("point pairs",
                      max_n_pairs,
                      "At most so many for two fibers; a core does about 1e9 "
                      "in a second.",
                      non_negative());
    prm.add_parameter("cells",
                      max_n_cells,
                      "At most about so many in the meshes of two fibers.",
                      non_negative());
  }
} // namespace Setae
