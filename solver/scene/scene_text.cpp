#include "solver/scene/scene_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>
#include <xxhash.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <numbers>
#include <numeric>
#include <optional>
#include <sstream>
#include <utility>

#include "solver/scene/overrides.hpp"
#include "solver/scene/scene_checks.hpp"
#include "solver/scene/scene_description.hpp"
#include "solver/scene/size_distribution.hpp"
#include "solver/support/close_names.hpp"
#include "solver/support/control_characters.hpp"

namespace slfb::description {
namespace {

using units::shortest;

/// " (did you mean ...?)" for a near miss, else nothing.
std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
  const auto nearest = std::ranges::min_element(known, {}, [&](const auto& k) { return edit_distance(word, k); });
  if (nearest == known.end() || edit_distance(word, *nearest) > std::max<std::size_t>(2, word.size() / 3)) return "";
  return fmt::format(" (did you mean \"{}\"?)", *nearest);
}

/// The value as a user would have written it.
std::string as_written(const toml::node& node) {
  if (const auto number = node.value_exact<double>()) return shortest(*number);
  using Flags = toml::format_flags;
  constexpr Flags strings_on_one_line =
      toml::toml_formatter::default_flags & ~(Flags::allow_literal_strings | Flags::allow_multi_line_strings);
  std::ostringstream text;
  text << toml::toml_formatter(node, strings_on_one_line);
  return text.str();
}

// --- reading ---------------------------------------------------------------------------------------------------------

/// Fills a scene from the parsed file. Checks names and types; ranges and physics come after.
class Reader {
 public:
  Reader(const toml::table& root, const std::vector<Override>& overrides, std::string file, Problems& problems,
         const SceneLaws& laws)
      : overrides_(overrides), file_(std::move(file)), problems_(problems), laws_(laws) {
    scopes_.push_back({&root, "", file_, {}});
  }

  void finish() { reject_unknown_keys(); }

  template <class Body>
  void section(const std::string& name, Body body) {
    const toml::node* node = find(name);
    const toml::table* table = node != nullptr ? node->as_table() : nullptr;
    if (node != nullptr && table == nullptr) wrong_type(name, *node, fmt::format("a table, written [{}]", name));
    const std::string place = table != nullptr ? place_of(name, *table) : file_;
    enter({table, name + ".", place, {}}, body);
  }

  template <class Item, class Body>
  void sections(const std::string& name, std::vector<Item>& items, Body body) {
    const toml::node* node = find(name);
    const toml::array* array = node != nullptr ? node->as_array() : nullptr;
    if (node == nullptr || array == nullptr || array->empty() || !array->is_array_of_tables()) {
      problems_.add_at(node != nullptr ? place_of(name, *node) : file_,
                       fmt::format("{}: missing; needed is at least one table, written [[{}]]", name, name));
      return;
    }
    items.resize(array->size());
    for (std::size_t i = 0; i < items.size(); ++i) {
      const toml::table& table = *array->get(i)->as_table();
      enter({&table, fmt::format("{}[{}].", name, i), place_of(name, table), {}}, [&] { body(items[i]); });
    }
  }

  void text(const std::string& key, std::string& value, const Presence& presence) {
    const toml::node* node = look_up(key, presence, "a text in quotes");
    if (node == nullptr) return;
    const auto found = node->value_exact<std::string>();
    if (!found) {
      wrong_type(key, *node, "a text in quotes");
    } else if (std::ranges::any_of(*found, is_control_character)) {
      problems_.add(path(key), "", "has a control character; allowed is text");
    } else {
      value = *found;
    }
  }

  void law(const std::string& key, std::string& value, const Presence& presence) {
    text(key, value, presence);
    // What the command line names lies where the command is given.
    if (override_of(path(key)) == nullptr) value = laws_.place(value, file_);
  }

  void boolean(const std::string& key, bool& value, const Presence& presence) {
    const toml::node* node = look_up(key, presence, "true or false");
    if (node == nullptr) return;
    if (const auto found = node->value_exact<bool>()) {
      value = *found;
    } else {
      wrong_type(key, *node, "true or false");
    }
  }

  template <class Integer>
  void integer(const std::string& key, Integer& value, const Allowed& allowed, const Presence& presence) {
    const toml::node* node = look_up(key, presence, allowed.words);
    if (node == nullptr) return;
    auto found = node->value_exact<std::int64_t>();
    // 1e6 is a real number in TOML and a whole one to who writes it.
    constexpr double largest = 9007199254740992.0;  // 2^53: to here every whole number has a double of its own
    if (const auto real = node->value_exact<double>(); real && std::abs(*real) <= largest && *real == std::floor(*real))
      found = static_cast<std::int64_t>(*real);
    if (!found) {
      wrong_type(key, *node, allowed.words);
    } else if (!allowed.contains(static_cast<double>(*found))) {
      problems_.add(path(key), "", fmt::format("out of range; allowed is {}", allowed.words));
    } else {
      value = static_cast<Integer>(*found);
    }
  }

  void number(const std::string& key, double& value, const units::Dimension& dimension, const Allowed&,
              const Presence& presence) {
    if (const toml::node* node = look_up(key, presence, describe_quantity(dimension))) {
      read_quantity(key, *node, dimension, value);
    }
  }

  void optional_number(const std::string& key, std::optional<double>& value, const units::Dimension& dimension,
                       const Allowed&, const Presence& presence) {
    const toml::node* node = look_up(key, presence, describe_quantity(dimension));
    double read = 0.0;
    if (node != nullptr && read_quantity(key, *node, dimension, read)) value = read;
  }

  void pair(const std::string& key, std::array<double, 2>& value, const units::Dimension& dimension, const Allowed&,
            const Presence& presence) {
    const std::string wanted = fmt::format("two values, for example [\"{0}\", \"{0}\"]", dimension.example);
    const toml::node* node = look_up(key, presence, wanted);
    if (node == nullptr) return;
    const toml::array* array = node->as_array();
    if (array == nullptr || array->size() != 2) {
      wrong_type(key, *node, wanted);
      return;
    }
    read_quantity(key, *array->get(0), dimension, value[0]);
    read_quantity(key, *array->get(1), dimension, value[1]);
  }

  template <class Enum, std::size_t N>
  void choice(const std::string& key, Enum& value, const std::array<Choice<Enum>, N>& choices,
              const Presence& presence) {
    std::string wanted;
    for (const auto& known : choices) wanted += fmt::format("{}\"{}\"", wanted.empty() ? "" : " | ", known.word);
    const toml::node* node = look_up(key, presence, wanted);
    if (node == nullptr) return;
    const auto found = node->value_exact<std::string>();
    const auto match = std::ranges::find(choices, std::string_view(found ? *found : ""), &Choice<Enum>::word);
    if (match == choices.end()) {
      problems_.add(path(key), "", fmt::format("is none of the choices; allowed is {}", wanted));
    } else {
      value = match->value;
    }
  }

  /// "count" or "total_mass"; a species with neither is only dropped.
  void particle_count(Species& species) {
    integer("count", species.count, zero_to_a_billion, optional);
    const toml::node* node = look_up("total_mass", optional, "");
    if (node == nullptr) return;
    if (find("count") != nullptr) {
      problems_.add(path("total_mass"), "", "stands beside count; allowed is one of the two");
      return;
    }
    double mass = 0.0;
    if (!read_quantity("total_mass", *node, units::mass, mass)) return;
    const double sphere_mass = species.density * std::numbers::pi / 6.0 * std::pow(species.diameter, 3);
    if (!(sphere_mass > 0.0)) return;  // the missing or impossible value is reported on its own
    // Whole spheres that the mass pays for; the thousandth forgives a mass rounded just below a whole number.
    const double count = std::floor(mass / sphere_mass + 1e-3);
    if (!(count >= 1.0 && count <= 1e9)) {
      problems_.add(
          path("total_mass"), "",
          fmt::format("is {} spheres of {} kg; allowed is 1 to 1000000000 spheres", count, shortest(sphere_mass)));
      return;
    }
    species.count = static_cast<std::int64_t>(count);
  }

 private:
  struct Scope {
    const toml::table* table;  ///< null for a section that the file does not have
    std::string prefix;
    std::string place;
    std::vector<std::string> known;
  };

  template <class Body>
  void enter(Scope scope, Body body) {
    if (scope.table != nullptr) {
      problems_.set_origin(scope.prefix.substr(0, scope.prefix.size() - 1), {scope.place, ""});
    }
    scopes_.push_back(std::move(scope));
    body();
    reject_unknown_keys();
    scopes_.pop_back();
  }

  [[nodiscard]] std::string path(const std::string& key) const { return scopes_.back().prefix + key; }

  [[nodiscard]] const Override* override_of(const std::string& full_path) const {
    const auto last = std::find_if(overrides_.rbegin(), overrides_.rend(),
                                   [&](const Override& change) { return change.path == full_path; });
    return last == overrides_.rend() ? nullptr : &*last;
  }

  [[nodiscard]] std::string place_of(const std::string& key, const toml::node& node) const {
    if (const Override* change = override_of(path(key))) return change->place();
    const auto line = node.source().begin.line;
    return line == 0 ? file_ : fmt::format("{}:{}", file_, line);
  }

  const toml::node* find(const std::string& key) {
    auto& scope = scopes_.back();
    if (std::ranges::find(scope.known, key) == scope.known.end()) scope.known.push_back(key);
    return scope.table != nullptr ? scope.table->get(key) : nullptr;
  }

  /// The node of a key that may be read; a missing or meaningless one is dealt with here.
  const toml::node* look_up(const std::string& key, Presence presence, std::string_view wanted) {
    const toml::node* node = find(key);
    if (node == nullptr) {
      if (presence.rule == Presence::Rule::required) {
        problems_.add_at(scopes_.back().place, fmt::format("{}: missing; needed is {}", path(key), wanted));
      }
      return nullptr;
    }
    problems_.set_origin(path(key), {place_of(key, *node), as_written(*node)});
    if (presence.rule == Presence::Rule::meaningless) {
      problems_.add(path(key), "", fmt::format("has no meaning here; {}", presence.reason));
      return nullptr;
    }
    return node;
  }

  void wrong_type(const std::string& key, const toml::node& node, std::string_view wanted) {
    problems_.set_origin(path(key), {place_of(key, node), as_written(node)});
    problems_.add(path(key), "", fmt::format("is of the wrong type; allowed is {}", wanted));
  }

  static std::string describe_quantity(const units::Dimension& dimension) {
    if (dimension.unit == "1") return fmt::format("{}, for example {}", dimension.name, dimension.example);
    return fmt::format("{}, for example \"{}\", or a bare number in {}", dimension.name, dimension.example,
                       dimension.unit);
  }

  bool read_quantity(const std::string& key, const toml::node& node, const units::Dimension& dimension, double& value) {
    if (node.is_number()) {
      value = *node.value<double>();
      return true;
    }
    const auto text = node.value_exact<std::string>();
    if (!text) {
      wrong_type(key, node, describe_quantity(dimension));
      return false;
    }
    try {
      value = units::parse_quantity(*text, dimension);
      return true;
    } catch (const units::UnitError& error) {
      problems_.add(path(key), "", error.what());
      return false;
    }
  }

  /// `line` is 0 for a key, or a table around it, that an override made.
  [[nodiscard]] std::string place_of_unknown(const std::string& name, toml::source_index line) const {
    const std::string full = path(name);
    const auto made_it = [&](const Override& change) {
      return change.path == full || (line == 0 && change.path.rfind(full + ".", 0) == 0);
    };
    const auto change = std::ranges::find_if(overrides_, made_it);
    if (change != overrides_.end()) return change->place();
    return line == 0 ? file_ : fmt::format("{}:{}", file_, line);
  }

  void reject_unknown_keys() {
    const Scope& scope = scopes_.back();
    if (scope.table == nullptr) return;
    for (const auto& [key, node] : *scope.table) {
      const std::string name(key.str());
      if (std::ranges::find(scope.known, name) != scope.known.end()) continue;
      const bool is_table = node.is_table() || node.is_array_of_tables();
      const std::string subject =
          is_table ? fmt::format("[{}]", path(name)) : fmt::format("{} = {}", path(name), as_written(node));
      problems_.add_at(place_of_unknown(name, key.source().begin.line),
                       fmt::format("{}: unknown key{}; allowed here is {}", subject, suggestion(name, scope.known),
                                   fmt::join(scope.known, ", ")));
    }
  }

  const std::vector<Override>& overrides_;
  std::string file_;
  Problems& problems_;
  const SceneLaws& laws_;
  std::vector<Scope> scopes_;
};

// --- writing ---------------------------------------------------------------------------------------------------------

std::string toml_text(std::string_view text) { return as_written(toml::value<std::string>(std::string(text))); }

/// Writes every key in the order of the description, a law as `law_name` makes it.
class Writer {
 public:
  /// \param for_name what is left out of the hash is not written
  Writer(std::string (*law_name)(const std::string& law), bool for_name) : law_name_(law_name), for_name_(for_name) {}

  template <class Body>
  void section(const std::string& name, Body body) {
    const std::size_t before = out_.size();
    out_ += fmt::format("[{}]\n", name);
    const std::size_t header = out_.size();
    body();
    if (out_.size() == header) out_.resize(before);  // all its keys are left out
  }
  template <class Item, class Body>
  void sections(const std::string& name, std::vector<Item>& items, Body body) {
    for (Item& item : items) {
      out_ += fmt::format("[[{}]]\n", name);
      body(item);
    }
  }
  void text(const std::string& key, const std::string& value, const Presence& presence) {
    line(key, toml_text(value), presence);
  }
  void law(const std::string& key, const std::string& value, const Presence& presence) {
    text(key, law_name_(value), presence);
  }
  void boolean(const std::string& key, bool value, const Presence& presence) {
    line(key, value ? "true" : "false", presence);
  }
  template <class Integer>
  void integer(const std::string& key, Integer value, const Allowed&, const Presence& presence) {
    line(key, fmt::format("{}", value), presence);
  }
  void number(const std::string& key, double value, const units::Dimension&, const Allowed&, const Presence& presence) {
    line(key, shortest(value), presence);
  }
  void optional_number(const std::string& key, const std::optional<double>& value, const units::Dimension&,
                       const Allowed&, const Presence& presence) {
    if (value) line(key, shortest(*value), presence);
  }
  void pair(const std::string& key, const std::array<double, 2>& value, const units::Dimension&, const Allowed&,
            const Presence& presence) {
    line(key, fmt::format("[{}, {}]", shortest(value[0]), shortest(value[1])), presence);
  }
  template <class Enum, std::size_t N>
  void choice(const std::string& key, Enum value, const std::array<Choice<Enum>, N>& choices,
              const Presence& presence) {
    line(key, toml_text(word_of(value, choices)), presence);
  }
  void particle_count(const Species& species) { line("count", fmt::format("{}", species.count), required); }

  [[nodiscard]] std::string take() { return std::move(out_); }

 private:
  void line(const std::string& key, std::string_view value, const Presence& presence) {
    if (presence.rule != Presence::Rule::meaningless && !presence.left_out && !(for_name_ && presence.left_out_of_name))
      out_ += fmt::format("{} = {}\n", key, value);
  }

  std::string (*law_name_)(const std::string& law);
  bool for_name_;
  std::string out_;
};

std::string written(const Scene& scene, const SceneLaws& laws, std::string (*law_name)(const std::string& law),
                    bool for_name) {
  Writer writer(law_name, for_name);
  Scene copy = scene;
  describe(writer, copy, laws);
  return writer.take();
}

/// Numerics that the quiescent tier does not solve with may be left out.
void fill_quiescent_defaults(Scene& scene) {
  if (scene.fluid.tier != FluidTier::quiescent) return;
  if (scene.fluid.time_step == 0.0) scene.fluid.time_step = scene.contact.time_step;
  if (scene.fluid.cell_height == 0.0) {
    for (const Species& species : scene.species) {
      scene.fluid.cell_height = std::max(scene.fluid.cell_height, 2.0 * species.diameter);
    }
  }
}

}  // namespace

Scene read_scene(const std::string& text, const std::string& origin, const std::vector<std::string>& overrides,
                 const SceneLaws& laws, const Scene& unwritten) {
  toml::table root;
  try {
    root = toml::parse(text, origin);
  } catch (const toml::parse_error& error) {
    const auto& begin = error.source().begin;
    const bool other_letters = error.description().find("utf-8") != std::string_view::npos;
    throw SceneError(fmt::format("{}:{}:{}: not valid TOML: {}{}", origin, begin.line, begin.column,
                                 error.description(), other_letters ? "; a scene is a text file in UTF-8" : ""));
  }
  const std::vector<Override> changes = split_overrides(overrides);
  apply_overrides(root, changes, laws);
  expand_size_distributions(root, origin);

  Problems problems(origin);
  Scene scene = unwritten;
  Reader reader(root, changes, origin, problems, laws);
  describe(reader, scene, laws);
  reader.finish();
  problems.raise();
  fill_quiescent_defaults(scene);
  check_scene(scene, problems, laws);
  return scene;
}

std::string canonical_text(const Scene& scene, const SceneLaws& laws) {
  return written(
      scene, laws, [](const std::string& law) { return law; }, false);
}

std::string hash_of(const Scene& scene, const SceneLaws& laws) {
  // What changes no result is left out.
  Scene physics = scene;
  physics.title.clear();
  physics.recording.checkpoint_interval = Recording{}.checkpoint_interval;
  physics.contact.allow_large_time_step = false;
  const std::string text =
      written(physics, laws, laws.identity, true) + fmt::format("numerics_version = {}\n", numerics_version);
  return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

}  // namespace slfb::description
