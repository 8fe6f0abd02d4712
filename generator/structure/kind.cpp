#include "structure/kind.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "error.hpp"
#include "structure/printed_table.hpp"

namespace assur::generator::structure {

namespace {

/// The kind whose joint `image[j]` has the type of joint j in `kind`.
Kind moved(const Kind& kind, const JointTable<JointIndex>& image) {
  Kind result(kind.size());
  for (const JointIndex joint : kind.keys()) {
    result[image[joint]] = kind[joint];
  }
  return result;
}

/// The orbits of the kinds, each led by its alphabetically first member.
std::vector<Model> orbits(const Group& group) {
  const std::vector<JointTable<JointIndex>> automorphisms = group.automorphisms();
  std::vector<Model> models;
  std::set<Kind> seen;
  for (const Kind& kind : all_kinds(group)) {
    if (seen.contains(kind)) {
      continue;
    }
    std::map<std::string, Kind> orbit;
    for (const JointTable<JointIndex>& image : automorphisms) {
      const Kind member = moved(kind, image);
      orbit.emplace(spell(group, member), member);
      seen.insert(member);
    }
    Model model{&group, 0, orbit.begin()->second, {}};
    for (const auto& entry : orbit) {
      const Kind& member = entry.second;
      const auto onto_representative = std::find_if(
          automorphisms.begin(), automorphisms.end(),
          [&](const auto& image) { return moved(member, image) == model.representative; });
      model.members.push_back({member, *onto_representative});
    }
    models.push_back(std::move(model));
  }
  return models;
}

/// The number of kinds that an orbit and a printed row have in common.
std::ptrdiff_t overlap(const Model& model, const PrintedRow& row) {
  return std::count_if(model.members.begin(), model.members.end(), [&](const Relabelling& member) {
    return std::find(row.kinds.begin(), row.kinds.end(), spell(*model.group, member.kind)) !=
           row.kinds.end();
  });
}

std::vector<Model> numbered_models(const Group& group) {
  std::vector<Model> models = orbits(group);
  const std::vector<PrintedRow>* printed = printed_table(group);
  if (printed == nullptr) {
    int number = 0;
    for (Model& model : models) {
      model.number = ++number;
    }
    return models;
  }
  for (Model& model : models) {
    const auto row = std::max_element(printed->begin(), printed->end(),
                                      [&](const PrintedRow& left, const PrintedRow& right) {
                                        return overlap(model, left) < overlap(model, right);
                                      });
    model.number = row->number;
  }
  std::sort(models.begin(), models.end(),
            [](const Model& left, const Model& right) { return left.number < right.number; });
  for (std::size_t index = 1; index < models.size(); ++index) {
    if (models[index].number == models[index - 1].number) {
      throw GeneratorError("structure", models[index].title(),
                           "two orbits match one printed row best");
    }
  }
  return models;
}

}  // namespace

std::string spell(const Group& group, const Kind& kind) {
  std::string text;
  auto type = kind.begin();
  for (const char letter : group.spelling()) {
    if (std::isupper(static_cast<unsigned char>(letter)) == 0) {
      text += letter;
    } else {
      text += *type++ == JointType::prismatic ? 'P' : 'R';
    }
  }
  return text;
}

std::optional<Kind> parse_kind(const Group& group, const std::string& text) {
  for (const Kind& kind : all_kinds(group)) {
    if (spell(group, kind) == text) {
      return kind;
    }
  }
  return std::nullopt;
}

std::vector<Kind> all_kinds(const Group& group) {
  const std::size_t joints = group.joints().size();
  std::vector<Kind> kinds;
  for (unsigned code = 0; code < (1U << joints); ++code) {
    Kind kind;
    for (std::size_t joint = 0; joint < joints; ++joint) {
      const bool prismatic = ((code >> (joints - 1 - joint)) & 1U) != 0;
      kind.add(prismatic ? JointType::prismatic : JointType::revolute);
    }
    kinds.push_back(std::move(kind));
  }
  return kinds;
}

std::string Model::title() const {
  return group->name() + (is_numbered() ? " model " + std::to_string(number) : "") + " (" +
         spell(*group, representative) + ")";
}

const std::vector<Model>& models_of(const Group& group) {
  static std::map<std::string, std::vector<Model>> cache;
  const auto [entry, fresh] = cache.try_emplace(group.name());
  if (fresh) {
    entry->second = numbered_models(group);
  }
  return entry->second;
}

const Model& model_of(const Group& group, const Kind& kind) {
  for (const Model& model : models_of(group)) {
    for (const Relabelling& member : model.members) {
      if (member.kind == kind) {
        return model;
      }
    }
  }
  throw GeneratorError("structure", group.name(), "a kind without a model");
}

}  // namespace assur::generator::structure
