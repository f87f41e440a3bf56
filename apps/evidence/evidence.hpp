// SPDX-License-Identifier: MIT
#pragma once
/// \file  What is said of a model, what is published, and how far they are apart. A new topic is a
/// function here, its own .cpp and one line in `topics()` in main.cpp.
#include <string>
#include <vector>

namespace eyrie::evidence {

struct Point {
  double x, y;
};

/// A curve, or points that stand for what others have measured or published.
struct Series {
  std::string name;
  std::vector<Point> points;
  bool published = false;  ///< drawn as points, not as a curve
};

/// One picture: docs/models/plots/<file>.svg.
struct Plot {
  std::string file, title, x, y;
  std::vector<Series> series{};
  double from_y = 0;  ///< lowest ordinate shown; curves below are cut off
};

/// As SVG: the same bytes wherever it is drawn.
[[nodiscard]] std::string svg(const Plot& plot);

/// One line of docs/models/README.md.
struct Row {
  std::string model;       ///< "point_mass, F-15C"
  std::string page;        ///< "flight.md"
  std::string claim;       ///< "ceiling, km"
  double here = 0;         ///< what the model gives
  double published = 0;    ///< what the source gives; 0: a law that `test` holds, no figures
  double tolerance = 0.1;  ///< of here / published - 1; 0: told and not checked, `why` says why
  std::string source;      ///< with "not seen" where nobody has looked
  std::string test;        ///< "Suite.Name": it must be in the tree
  std::string plot = "";   ///< file of a plot, without .svg
  std::string why = "";    ///< why it is not checked
};

struct Evidence {
  std::vector<Row> rows;
  std::vector<Plot> plots;
};

/// `home`: the folder that has data/.
[[nodiscard]] Evidence of_air_and_laws(const std::string& home);
[[nodiscard]] Evidence of_flight(const std::string& home);
[[nodiscard]] Evidence of_missiles(const std::string& home);
[[nodiscard]] Evidence of_sensors(const std::string& home);

}  // namespace eyrie::evidence
