#pragma once

#include "reports/report_contents.hpp"

namespace slfb::paper {

/// What the report says of the paper: title, introduction with DOI, how to read its figures, methods (methods.md), and
/// the study that the navigation names. Throws std::runtime_error where methods.md cannot be read.
reports::WorkTexts report_texts();

}  // namespace slfb::paper
