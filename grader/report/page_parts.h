#pragma once

namespace grade {

/// page.css and page.js, as every page holds them; the build makes them texts.
extern const char* const page_style;
extern const char* const page_script;

}  // namespace grade
