#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "correlations/catalogue.hpp"

namespace slfb {

/// {"laws": [{"name", "kind", "source", "range", …}, …]}, all laws or those of one kind ("" for all).
nlohmann::json laws_as_json(const std::string& kind);

/// {"law", the arguments the law takes, the values it gives, "in_range", "units"}.
nlohmann::json evaluation_as_json(const CatalogueEntry& entry, const LawArguments& arguments);

}  // namespace slfb
