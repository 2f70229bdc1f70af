// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays.h"
#include "Bindings.h"
#include "Listener.h"
#include "Proof/Certificate/Certificate.h"
#include "Run/Output/ComparedSurface.h"
#include "Run/Report/CertificateTable.h"
#include "Run/Report/PairWarnings.h"
#include "Run/Report/ReportJson.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

namespace bonedecimate
{
namespace
{
nb::dict ToDict(
  Certificate&& certificate, const PairFigures& pair, std::vector<std::string>&& warnings)
{
  nb::dict fields;
  const std::vector<ReportEntry> entries = CertificateEntries(certificate, pair);
  fields["entries"] = ToList(entries);
  fields["json"] = ReportJson(entries);
  fields["status"] = certificate.Status;
  fields["problem"] = StatusSentence(certificate.Status);
  fields["warnings"] = std::move(warnings);
  SignedDistances& reference = certificate.ReferenceToResult.Points;
  SignedDistances& result = certificate.ResultToReference.Points;
  fields["reference_distance"] = ToArray(std::move(reference.Distance));
  fields["reference_side"] = ToArray(std::move(reference.Side));
  fields["result_distance"] = ToArray(std::move(result.Distance));
  fields["result_side"] = ToArray(std::move(result.Side));
  return fields;
}

nb::dict RunCertificate(const PointsIn& referencePoints, const TrianglesIn& referenceTriangles,
  const PointsIn& points, const TrianglesIn& triangles, const CertificateOptions& options,
  bool surfaces, nb::object progress, const LeftOutIn& leftOutOfReference,
  const LeftOutIn& leftOutOfResult)
{
  const Surface reference = ToSurface(referencePoints, referenceTriangles);
  const Surface result = ToSurface(points, triangles);
  const std::vector<LeftOutShape> ofReference = ToLeftOut(leftOutOfReference);
  const std::vector<LeftOutShape> ofResult = ToLeftOut(leftOutOfResult);
  PairFigures figures;
  Certificate certificate = Listener(std::move(progress))
                              .Hear(
                                [&](const Monitor& monitor)
                                {
                                  return CertifyPair({ reference, ofReference },
                                    { result, ofResult }, options, surfaces, monitor, figures);
                                });
  return ToDict(std::move(certificate), figures,
    PairWarnings(reference, result, options.Tolerance.value_or(0.0), figures));
}
}

//------------------------------------------------------------------------------
void BindCertify(nb::module_& module)
{
  nb::enum_<CertificateStatus>(module, "CertificateStatus", "Whether two surfaces can be compared.")
    .value("Good", CertificateStatus::Good)
    .value("EmptyReference", CertificateStatus::EmptyReference)
    .value("EmptyResult", CertificateStatus::EmptyResult)
    .value("BadReference", CertificateStatus::BadReference)
    .value("BadResult", CertificateStatus::BadResult)
    .value("BadTolerance", CertificateStatus::BadTolerance)
    .value("Aborted", CertificateStatus::Aborted);
  nb::class_<CertificateOptions>(module, "CertificateOptions", "As in Certificate.h.")
    .def(nb::init<>())
    .def_rw("tolerance", &CertificateOptions::Tolerance, nb::arg().none())
    .def(
      "set_tolerances",
      [](CertificateOptions& options, const NumbersIn& map)
      { options.ToleranceMap = *ToNumbers(map); },
      nb::arg("tolerances"))
    .def_rw("tight_bounds", &CertificateOptions::TightBounds)
    .def_rw("relative_gap", &CertificateOptions::RelativeGap)
    .def_rw("with_boundaries", &CertificateOptions::WithBoundaries)
    .def_rw("with_means", &CertificateOptions::WithMeans)
    .def_rw("mean_precision", &CertificateOptions::MeanPrecision)
    .def_rw("with_point_distances", &CertificateOptions::WithPointDistances)
    .def_rw("threads", &CertificateOptions::NumberOfThreads);
  module.def("certify", &RunCertificate, nb::arg("reference_points"),
    nb::arg("reference_triangles"), nb::arg("points"), nb::arg("triangles"), nb::arg("options"),
    nb::arg("surfaces"), nb::arg("progress").none(), nb::arg("left_out_of_reference") = LeftOutIn(),
    nb::arg("left_out_of_result") = LeftOutIn(), "Proved bounds of the distance of two surfaces.");
}
}
