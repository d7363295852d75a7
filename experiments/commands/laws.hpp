#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "correlations/catalogue.hpp"

namespace slfb {

/// Adds `slfb laws`: the catalogue of literature laws as a table or as JSON.
void add_laws_command(CLI::App& app);

/// Adds `slfb law NAME`: one law with the values it gives for the arguments it takes.
void add_law_command(CLI::App& app);

/// {"laws": [{"name", "kind", "source", "range", …}, …]}, all laws or those of one kind ("" for all).
nlohmann::json laws_as_json(const std::string& kind);

/// {"law", the arguments the law takes, the values it gives, "in_range", "units"}.
nlohmann::json evaluation_as_json(const CatalogueEntry& entry, const LawArguments& arguments);

}  // namespace slfb
