// Declares the use of a rendering in a protocol: its values are copied into a surface of the protocol's text.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/study_files/rendering_files.h"
#include "protocols/design/protocol.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// What a rendering cannot be used for as it is, and what to do: its model does not exist or is of another version, its
/// texture is missing or has changed. Empty: nothing. Reads the texture, and decodes it only if it has changed.
struct RenderingRemarks {
  std::vector<Phrase> problems{};  ///< it cannot be used
  std::vector<Phrase> warnings{};
};
RenderingRemarks remarks_about(const Rendering& rendering, const ModelRegistry& models,
                               const std::filesystem::path& study);

/// A surface of a protocol, an entry of "stimuli", that a rendering can replace.
struct UsableSurface {
  std::string name{};
  bool has_texture = false;
  std::optional<std::string> texture_factor{};  ///< the factor whose level its texture is
};
/// Those of a text, by name; none of a text that is not JSON.
std::vector<UsableSurface> usable_surfaces(const std::string& protocol);

/// The names of the renderings that the surfaces of a valid protocol note.
std::vector<std::string> renderings_in(const std::string& protocol);

/// The pointers of the notes of surfaces that name this rendering; none in a text that is not JSON.
std::vector<std::string> notes_of(const std::string& protocol, const std::string& rendering);

/// Where the values of a rendering are copied to.
struct RenderingPlace {
  std::optional<std::string>
      replaced{};              ///< a surface; absent: a new one, which is named after the rendering
  bool keeps_texture = false;  ///< a replaced surface keeps its texture, or its factor
};

/// Why a surface cannot get the texture of a rendering: the protocol shows pictures, and the texture has none. Empty: it can.
/// `picture`: the photograph of the texture in the study; empty: none.
std::optional<Phrase> complaint_about_picture(const Protocol& protocol, const Rendering& rendering,
                                              const std::string& picture);

/// The protocol's text with the values of a rendering as a surface.
///
/// Values are edited, everything else stays as it is written. The surface has the key `x-rendering` with the name of the
/// rendering, which sessions do not read. A texture of the protocol with the height field of the rendering is used, otherwise one
/// is added; it has `picture` if that is not empty and it has none. A replaced surface loses what would change the values: its equal force
/// and its bodies.
///
/// Errors: ProtocolError for a text that is not JSON, and for a place that does not exist.
std::string with_rendering(const std::string& protocol, const Rendering& rendering,
                           const std::string& name, const RenderingPlace& place,
                           const std::string& picture = {});

/// A value that two texts of a protocol do not have in common.
struct ChangedValue {
  std::string pointer{};
  std::string before{};  ///< in the unit of a form; empty: none
  std::string after{};
};
/// The changes from one text to another, by place; objects that are new or gone are listed value by value. Errors:
/// ProtocolError for a text that is not JSON.
std::vector<ChangedValue> changed_values(const std::string& before, const std::string& after);

}  // namespace asperity
