#pragma once

#include "convergence/record.h"
#include "report/plot.h"

namespace grade::convergence {

/// The result for a terminal: for each scene its curves, what a bias does to them, and the comparison.
std::string table(const ConvergenceRecord& record, bool color);

/// The result as Markdown, with the plots beside it.
std::string report(const ConvergenceRecord& record);

/// What a plot has below: CPU seconds, or rays of all kinds.
enum class Against { seconds, rays };

/// RMSE of all curves of a scene, with 95 % ribbons and guides of slopes -1/2, -3/4 and -1.
Plot error_plot(const SceneRecord& scene, Against against);

/// The file of such a plot: "soft_shadow-seconds.svg".
std::string plot_file(const SceneRecord& scene, Against against);

}  // namespace grade::convergence
