// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 The Setae authors

#include <deal.II/base/polynomial.h>
#include <deal.II/base/tensor_product_polynomials.h>
#include <deal.II/base/utilities.h>

#include <deal.II/hp/q_collection.h>

#include <setae/fe/fe_hermite.h>

#include <vector>

namespace Setae
{
  using namespace dealii;

  namespace
  {
    /**
     * The four polynomials for h = 1, vertex by vertex: deal.II puts the two
     * that interpolate the values first.
     */
    TensorProductPolynomials<1>
    unit_polynomials()
    {
      std::vector<Polynomials::Polynomial<double>> polynomials;
      for (const unsigned int i : {0, 2, 1, 3})
        polynomials.emplace_back(Polynomials::HermiteInterpolation(i));
      return TensorProductPolynomials<1>(polynomials);
    }



    /**
     * Multiply the shape functions of the derivative degrees of freedom by the
     * length scale @p h, in every table that was asked for (the others are
     * empty).
     */
    template <typename Output>
    void
    scale_derivative_shapes(const double h, Output &output)
    {
      const auto scale = [h](auto &table) {
        for (const unsigned int shape : {1, 3})
          for (unsigned int q = 0; q < table.size(1); ++q)
            table(shape, q) *= h;
      };
      scale(output.shape_values);
      scale(output.shape_gradients);
      scale(output.shape_hessians);
      scale(output.shape_3rd_derivatives);
    }
  } // namespace



  template <int dim, int spacedim>
  FE_Hermite<dim, spacedim>::FE_Hermite()
    : FE_Poly<dim, spacedim>(
        unit_polynomials(),
        FiniteElementData<dim>({2, 0}, 1, 3, FiniteElementData<dim>::H2),
        std::vector<bool>(4, false),
        std::vector<ComponentMask>(4, ComponentMask(1, true)))
  {}



  template <int dim, int spacedim>
  double
  FE_Hermite<dim, spacedim>::length_scale(const CellIterator &cell)
  {
    return cell->vertex(0).distance(cell->vertex(1));
  }



  template <int dim, int spacedim>
  std::string
  FE_Hermite<dim, spacedim>::get_name() const
  {
    return "FE_Hermite<" + Utilities::dim_string(dim, spacedim) + ">()";
  }



  template <int dim, int spacedim>
  std::unique_ptr<FiniteElement<dim, spacedim>>
  FE_Hermite<dim, spacedim>::clone() const
  {
    return std::make_unique<FE_Hermite<dim, spacedim>>(*this);
  }



  template <int dim, int spacedim>
  auto
  FE_Hermite<dim, spacedim>::get_data(const UpdateFlags update_flags,
                                      const Mapping<dim, spacedim> &mapping,
                                      const Quadrature<dim>        &quadrature,
                                      ElementOutput &output) const
    -> std::unique_ptr<ElementInternal>
  {
    auto data = FE_Poly<dim, spacedim>::get_data(update_flags,
                                                 mapping,
                                                 quadrature,
                                                 output);

    // On cells the base class writes the values straight into the output and
    // forgets them; here they change from cell to cell and must be kept.
    if (update_flags & update_values)
      {
        auto &values =
          dynamic_cast<typename FE_Poly<dim, spacedim>::InternalData &>(*data)
            .shape_values;
        values.reinit(this->n_dofs_per_cell(), quadrature.size());
        for (unsigned int i = 0; i < this->n_dofs_per_cell(); ++i)
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            values(i, q) = this->shape_value(i, quadrature.point(q));
      }
    return data;
  }



  template <int dim, int spacedim>
  void
  FE_Hermite<dim, spacedim>::fill_fe_values(
    const CellIterator &cell,
    const CellSimilarity::Similarity,
    const Quadrature<dim>        &quadrature,
    const Mapping<dim, spacedim> &mapping,
    const MappingInternal        &mapping_internal,
    const MappingOutput          &mapping_output,
    const ElementInternal        &element_internal,
    ElementOutput                &output) const
  {
    // Whatever the last cell left in the output is already scaled, so the base
    // class must not keep it for a cell that is a translation of the last.
    FE_Poly<dim, spacedim>::fill_fe_values(cell,
                                           CellSimilarity::none,
                                           quadrature,
                                           mapping,
                                           mapping_internal,
                                           mapping_output,
                                           element_internal,
                                           output);
    if (element_internal.update_each & update_values)
      output.shape_values =
        dynamic_cast<const typename FE_Poly<dim, spacedim>::InternalData &>(
          element_internal)
          .shape_values;

    scale_derivative_shapes(length_scale(cell), output);
  }



  template <int dim, int spacedim>
  void
  FE_Hermite<dim, spacedim>::fill_fe_face_values(
    const CellIterator             &cell,
    const unsigned int              face_no,
    const hp::QCollection<dim - 1> &quadrature,
    const Mapping<dim, spacedim>   &mapping,
    const MappingInternal          &mapping_internal,
    const MappingOutput            &mapping_output,
    const ElementInternal          &element_internal,
    ElementOutput                  &output) const
  {
    FE_Poly<dim, spacedim>::fill_fe_face_values(cell,
                                                face_no,
                                                quadrature,
                                                mapping,
                                                mapping_internal,
                                                mapping_output,
                                                element_internal,
                                                output);
    scale_derivative_shapes(length_scale(cell), output);
  }



  template class FE_Hermite<1, 3>;
} // namespace Setae
