// The parameters of the force models, in a sentence for a paper and in a table for reference.

#pragma once

#include <string>

#include "app/report/text/report_sections.h"

namespace asperity {

/// The parameters as they were rendered that the protocol states or that differ from the defaults of the force model: "The
/// parameters of the force model were: amplitude 50 µm to 100 µm, wavelength 2.5 mm. All others had their default values; the
/// report of the study lists all parameters. The friction law was elastoplastic." Empty where none were stored.
std::string paper_parameters(const ReportFacts& facts);

/// For reference: every parameter of every force model with its rendered values and their unit. Without parts where none were
/// stored.
ReportSection parameters_section(const ReportFacts& facts);

}  // namespace asperity
