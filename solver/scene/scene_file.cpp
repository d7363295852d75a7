#include "solver/scene/scene_file.hpp"

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

#include "solver/laws/user_law.hpp"
#include "solver/scene/scene_checks.hpp"
#include "solver/scene/scene_description.hpp"
#include "solver/support/close_names.hpp"

namespace slfb {
namespace {

using description::Allowed;
using description::Choice;
using description::Presence;
using description::Problems;
using description::shortest;

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

// --- overrides -------------------------------------------------------------------------------------------------------

struct PathSegment {
  std::string key;
  std::optional<std::size_t> index;
};

struct Override {
  std::string text;  ///< "key=value"
  std::string path;
  std::vector<PathSegment> segments;
  std::string value;
  [[nodiscard]] std::string place() const { return "--set " + text; }
};

std::string trimmed(std::string text) {
  const auto blank = [](unsigned char c) { return std::isspace(c) != 0; };
  text.erase(std::find_if_not(text.rbegin(), text.rend(), blank).base(), text.end());
  text.erase(text.begin(), std::find_if_not(text.begin(), text.end(), blank));
  return text;
}

Override split_override(const std::string& text) {
  const auto fail = [&](std::string_view what) {
    return SceneError(
        fmt::format("--set {}: {}; allowed is key=value with the dotted path of the scene file, for "
                    "example \"contact.stiffness=1e3 N/m\" or \"stage[2].repetitions=5\"",
                    text, what));
  };
  const auto equals = text.find('=');
  if (equals == std::string::npos) throw fail("no \"=\"");
  Override result{text, trimmed(text.substr(0, equals)), {}, trimmed(text.substr(equals + 1))};
  std::istringstream path(result.path);
  for (std::string part; std::getline(path, part, '.');) {
    PathSegment segment{part, std::nullopt};
    if (const auto bracket = part.find('['); bracket != std::string::npos) {
      const auto digits = part.substr(bracket + 1, part.size() - bracket - 2);
      if (part.back() != ']' || digits.empty() || digits.size() > 6 ||
          !std::ranges::all_of(digits, [](unsigned char c) { return std::isdigit(c) != 0; })) {
        throw fail("the index in the key is not [0], [1], …");
      }
      segment = {part.substr(0, bracket), std::stoul(digits)};
    }
    if (segment.key.empty()) throw fail("the key has an empty part");
    result.segments.push_back(segment);
  }
  if (result.segments.empty() || result.path.back() == '.') throw fail("the key has an empty part");
  if (result.segments.back().index) throw fail("the key names a whole table");
  return result;
}

/// The value as TOML where it is TOML (numbers, booleans, arrays, quoted strings), else the bare text.
void insert_value(toml::table& table, const std::string& key, const std::string& value) {
  if (value.find('\n') == std::string::npos) {
    try {
      auto parsed = toml::parse("value = " + value);
      table.insert_or_assign(key, std::move(*parsed.get("value")));
      return;
    } catch (const toml::parse_error&) {
      // "1e3 N/m" or a word: the text is the value
    }
  }
  table.insert_or_assign(key, value);
}

void apply_override(toml::table& root, const Override& change) {
  const auto fail = [&](std::string_view what) {
    return SceneError(fmt::format("{}: {} = {}: {}", change.place(), change.path, change.value, what));
  };
  toml::table* table = &root;
  for (std::size_t i = 0; i + 1 < change.segments.size(); ++i) {
    const auto& [key, index] = change.segments[i];
    if (!table->contains(key) && !index) table->insert(key, toml::table{});
    toml::node* node = table->get(key);
    if (index) {
      const toml::array* array = node != nullptr ? node->as_array() : nullptr;
      const std::size_t size = array != nullptr ? array->size() : 0;
      if (*index >= size) throw fail(fmt::format("the scene has {} [[{}]], counted from 0", size, key));
      node = node->as_array()->get(*index);
    }
    table = node->as_table();
    if (table == nullptr)
      throw fail(fmt::format("\"{}\" is not a table; allowed is a path such as stage[2].duration", key));
  }
  const std::string& key = change.segments.back().key;
  // An override speaks for the whole choice: count replaces total_mass and the other way round.
  if (key == "count") table->erase("total_mass");
  if (key == "total_mass") table->erase("count");
  insert_value(*table, key, change.value);
}

/// An override of the contact law speaks for the whole choice: what the file says of another law goes.
void forget_other_contact_law(toml::table& root, const std::vector<Override>& changes) {
  toml::table* contact = root["contact"].as_table();
  const auto change = std::find_if(changes.rbegin(), changes.rend(),
                                   [](const Override& candidate) { return candidate.path == "contact.law"; });
  if (contact == nullptr || change == changes.rend()) return;
  const auto forget = [&](std::initializer_list<std::string_view> keys) {
    for (const std::string_view key : keys) contact->erase(key);
  };
  const bool quoted = change->value.starts_with('"') && change->value.ends_with('"');
  const std::string law = quoted ? change->value.substr(1, change->value.size() - 2) : change->value;
  if (law == "hertz") forget({"stiffness", "tangential_stiffness_ratio", "tangential_damping_ratio"});
  if (law == "linear") forget({"youngs_modulus", "poisson_ratio", "rigid_walls"});
}

// --- reading ---------------------------------------------------------------------------------------------------------

/// Fills a scene from the parsed file. Checks names and types; ranges and physics come after.
class Reader {
 public:
  Reader(const toml::table& root, const std::vector<Override>& overrides, std::string file, Problems& problems)
      : overrides_(overrides), file_(std::move(file)), problems_(problems) {
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

  void text(const std::string& key, std::string& value, Presence presence) {
    const toml::node* node = look_up(key, presence, "a text in quotes");
    if (node == nullptr) return;
    if (const auto found = node->value_exact<std::string>()) {
      value = *found;
    } else {
      wrong_type(key, *node, "a text in quotes");
    }
  }

  void boolean(const std::string& key, bool& value, Presence presence) {
    const toml::node* node = look_up(key, presence, "true or false");
    if (node == nullptr) return;
    if (const auto found = node->value_exact<bool>()) {
      value = *found;
    } else {
      wrong_type(key, *node, "true or false");
    }
  }

  template <class Integer>
  void integer(const std::string& key, Integer& value, const Allowed& allowed, Presence presence) {
    const toml::node* node = look_up(key, presence, allowed.words);
    if (node == nullptr) return;
    const auto found = node->value_exact<std::int64_t>();
    if (!found) {
      wrong_type(key, *node, allowed.words);
    } else if (!allowed.contains(static_cast<double>(*found))) {
      problems_.add(path(key), "", fmt::format("out of range; allowed is {}", allowed.words));
    } else {
      value = static_cast<Integer>(*found);
    }
  }

  void number(const std::string& key, double& value, const units::Dimension& dimension, const Allowed&,
              Presence presence) {
    if (const toml::node* node = look_up(key, presence, describe_quantity(dimension))) {
      read_quantity(key, *node, dimension, value);
    }
  }

  void pair(const std::string& key, std::array<double, 2>& value, const units::Dimension& dimension, const Allowed&,
            Presence presence) {
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
  void choice(const std::string& key, Enum& value, const std::array<Choice<Enum>, N>& choices, Presence presence) {
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
    integer("count", species.count, description::zero_to_a_billion, description::optional);
    const toml::node* node = look_up("total_mass", description::optional, "");
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
  std::vector<Scope> scopes_;
};

// --- writing ---------------------------------------------------------------------------------------------------------

std::string toml_text(std::string_view text) { return as_written(toml::value<std::string>(std::string(text))); }

/// Writes every key in the order of the description.
class Writer {
 public:
  template <class Body>
  void section(const std::string& name, Body body) {
    out_ += fmt::format("[{}]\n", name);
    body();
  }
  template <class Item, class Body>
  void sections(const std::string& name, std::vector<Item>& items, Body body) {
    for (Item& item : items) {
      out_ += fmt::format("[[{}]]\n", name);
      body(item);
    }
  }
  void text(const std::string& key, const std::string& value, Presence presence) {
    line(key, toml_text(value), presence);
  }
  void boolean(const std::string& key, bool value, Presence presence) { line(key, value ? "true" : "false", presence); }
  template <class Integer>
  void integer(const std::string& key, Integer value, const Allowed&, Presence presence) {
    line(key, fmt::format("{}", value), presence);
  }
  void number(const std::string& key, double value, const units::Dimension&, const Allowed&, Presence presence) {
    line(key, shortest(value), presence);
  }
  void pair(const std::string& key, const std::array<double, 2>& value, const units::Dimension&, const Allowed&,
            Presence presence) {
    line(key, fmt::format("[{}, {}]", shortest(value[0]), shortest(value[1])), presence);
  }
  template <class Enum, std::size_t N>
  void choice(const std::string& key, Enum value, const std::array<Choice<Enum>, N>& choices, Presence presence) {
    line(key, toml_text(description::word_of(value, choices)), presence);
  }
  void particle_count(const Species& species) {
    line("count", fmt::format("{}", species.count), description::required);
  }

  [[nodiscard]] std::string take() { return std::move(out_); }

 private:
  void line(const std::string& key, std::string_view value, Presence presence) {
    if (presence.rule != Presence::Rule::meaningless && !presence.left_out)
      out_ += fmt::format("{} = {}\n", key, value);
  }

  std::string out_;
};

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

Scene load_scene(const std::filesystem::path& file, const Overrides& overrides) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  const bool regular = std::filesystem::is_regular_file(file);
  if (regular && stream && std::filesystem::file_size(file) == 0)
    throw SceneError(fmt::format("{}: is empty; needed is a scene file (TOML)", file.string()));
  if (!regular || !(text << stream.rdbuf())) {
    throw SceneError(fmt::format("{}: cannot be read; needed is a scene file (TOML)", file.string()));
  }
  return parse_scene(text.str(), file.string(), overrides);
}

Scene parse_scene(const std::string& text, const std::string& origin, const Overrides& overrides) {
  toml::table root;
  try {
    root = toml::parse(text, origin);
  } catch (const toml::parse_error& error) {
    const auto& begin = error.source().begin;
    throw SceneError(
        fmt::format("{}:{}:{}: not valid TOML: {}", origin, begin.line, begin.column, error.description()));
  }
  std::vector<Override> changes;
  for (const std::string& change : overrides) changes.push_back(split_override(change));
  forget_other_contact_law(root, changes);
  for (const Override& change : changes) apply_override(root, change);

  Problems problems(origin);
  Scene scene;
  Reader reader(root, changes, origin, problems);
  description::describe(reader, scene);
  reader.finish();
  problems.raise();
  fill_quiescent_defaults(scene);
  description::check_scene(scene, problems);
  return scene;
}

void validate_scene(const Scene& scene) {
  Problems problems("scene");
  description::check_scene(scene, problems);
}

std::string canonical_toml(const Scene& scene) {
  Writer writer;
  Scene copy = scene;
  description::describe(writer, copy);
  return writer.take();
}

std::string scene_hash(const Scene& scene) {
  // What changes no result is left out.
  Scene physics = scene;
  physics.title.clear();
  physics.recording.checkpoint_interval = Recording{}.checkpoint_interval;
  physics.contact.allow_large_time_step = false;
  // A law from outside the suite is what its file says, not where the file lies.
  for (std::string* law : {&physics.coupling.drag_law, &physics.contact.law})
    if (is_user_law(*law)) *law = user_law_hash(*law);
  const std::string text = canonical_toml(physics) + fmt::format("numerics_version = {}\n", numerics_version);
  return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

}  // namespace slfb
