#pragma once

#include <filesystem>
#include <string>

#include "experiments/work/judge.hpp"
#include "experiments/work/work.hpp"

/// The reproduction of a work as an article: the files of experiments/ID/article/ with their places filled from runs,
/// claims and figures.
namespace slfb {

/// What a template may name between double braces, as `slfb article --help` lists it.
extern const char* const article_places;

/// Writes article.md, article.html, metadata.yaml and the named figures (figures/ID.*) into `folder`. Every figure that
/// the text names is drawn. \param out folder of runs/ Throws std::runtime_error with file and line for a place that
/// names what there is not, and std::invalid_argument for a work without article.
void write_article(const Work& work, const Judgement& judgement, const std::filesystem::path& out,
                   const std::filesystem::path& folder);

}  // namespace slfb
