// SPDX-License-Identifier: MIT
#pragma once

#include <QStringList>

namespace fodscope {

class InspectionController;

/// Decides what files dropped on the window are meant as: a session is opened; a cloud or mesh becomes the reference
/// while there is none, else the map; several clouds are nominal maps; a CSV is a transform, a YAML a grid, a JSON a
/// world. Without an open inspection a new one is begun.
void takeDroppedFiles(InspectionController& controller, const QStringList& files);

}  // namespace fodscope
