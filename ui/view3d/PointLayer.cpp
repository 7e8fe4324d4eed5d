// SPDX-License-Identifier: MIT
#include "ui/view3d/PointLayer.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fodscope {
namespace {

/// Below this number nothing is left out while the camera moves.
constexpr std::size_t kCoarseAbove = 300000;
constexpr std::size_t kCoarsePoints = 120000;
constexpr int kSpacingProbes = 24;

vtkSmartPointer<vtkCellArray> vertexCell(const std::vector<std::int64_t>& indices, std::size_t stride) {
    vtkNew<vtkCellArray> cells;
    std::vector<vtkIdType> ids;
    ids.reserve(indices.size() / stride + 1);
    for (std::size_t i = 0; i < indices.size(); i += stride)
        ids.push_back(indices[i]);
    if (!ids.empty()) cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    return cells;
}

}  // namespace

class PointLayer::Actors {
  public:
    explicit Actors(vtkRenderer* renderer) : renderer_(renderer) {}
    ~Actors() {
        for (const auto& entry : entries)
            renderer_->RemoveActor(entry->actor);
    }

    struct Entry {
        vtkNew<vtkPolyData> data;
        vtkNew<vtkPolyDataMapper> mapper;
        vtkNew<vtkActor> actor;
        vtkSmartPointer<vtkCellArray> all;
        vtkSmartPointer<vtkCellArray> part;
    };

    Entry& add() {
        entries.push_back(std::make_unique<Entry>());
        Entry& entry = *entries.back();
        entry.data->SetPoints(points);
        entry.data->GetPointData()->SetScalars(colours);
        entry.mapper->SetInputData(entry.data);
        entry.mapper->SetColorModeToDirectScalars();
        entry.mapper->SetClippingPlanes(planes);
        entry.actor->SetMapper(entry.mapper);
        entry.actor->SetUserMatrix(matrix);
        entry.actor->GetProperty()->LightingOff();
        renderer_->AddActor(entry.actor);
        return entry;
    }

    vtkSmartPointer<vtkRenderer> renderer_;
    vtkNew<vtkPoints> points;
    vtkNew<vtkUnsignedCharArray> colours;
    vtkNew<vtkPlaneCollection> planes;
    vtkNew<vtkMatrix4x4> matrix;
    std::vector<std::unique_ptr<Entry>> entries;
};

PointLayer::PointLayer(vtkRenderer* renderer) : actors_(std::make_unique<Actors>(renderer)) {
    actors_->colours->SetNumberOfComponents(3);
}

PointLayer::~PointLayer() = default;

void PointLayer::setPoints(std::span<const Eigen::Vector3d> points) {
    copyPoints(points);
    measureSpacing();
    setOneGroup();
}

void PointLayer::setPoints(std::span<const Eigen::Vector3d> points, std::span<const QRgb> colours,
                           std::vector<PointGroup> groups) {
    copyPoints(points);
    setColours(colours);
    setGroups(std::move(groups));
}

void PointLayer::copyPoints(std::span<const Eigen::Vector3d> points) {
    points_.resize(points.size());
    bounds_ = {};
    for (std::size_t i = 0; i < points.size(); ++i) {
        points_[i] = points[i].cast<float>();
        bounds_.extend(points[i]);
    }

    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetNumberOfComponents(3);
    coordinates->SetNumberOfTuples(static_cast<vtkIdType>(points_.size()));
    for (std::size_t i = 0; i < points_.size(); ++i) {
        coordinates->SetTypedTuple(static_cast<vtkIdType>(i), points_[i].data());
    }
    actors_->points->SetData(coordinates);
    actors_->colours->SetNumberOfTuples(static_cast<vtkIdType>(points_.size()));
    actors_->colours->Fill(160);
}

void PointLayer::setOneGroup() {
    PointGroup all;
    all.indices.resize(points_.size());
    std::iota(all.indices.begin(), all.indices.end(), std::int64_t{0});
    groups_.clear();
    groups_.push_back(std::move(all));
    rebuild();
}

void PointLayer::setColours(std::span<const QRgb> colours) {
    const std::size_t count = std::min(colours.size(), points_.size());
    unsigned char* out = actors_->colours->GetPointer(0);
    for (std::size_t i = 0; i < count; ++i) {
        out[3 * i] = static_cast<unsigned char>(qRed(colours[i]));
        out[3 * i + 1] = static_cast<unsigned char>(qGreen(colours[i]));
        out[3 * i + 2] = static_cast<unsigned char>(qBlue(colours[i]));
    }
    actors_->colours->Modified();
    for (const auto& entry : actors_->entries)
        entry->data->Modified();
}

void PointLayer::setGroups(std::vector<PointGroup> groups) {
    groups_ = std::move(groups);
    rebuild();
}

void PointLayer::setTransform(const Transform& transform) {
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            actors_->matrix->SetElement(row, column, transform.matrix()(row, column));
        }
    }
}

void PointLayer::setVisible(bool visible) {
    visible_ = visible;
    for (std::size_t i = 0; i < actors_->entries.size(); ++i)
        actors_->entries[i]->actor->SetVisibility(visible && i < groups_.size() && !groups_[i].indices.empty());
}

void PointLayer::setOpacity(double opacity) {
    opacity_ = opacity;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
        actors_->entries[i]->actor->GetProperty()->SetOpacity(opacity_ * groups_[i].opacity);
    }
}

void PointLayer::setPeelHeight(std::optional<double> height_m) {
    if (peel_m_ == height_m) return;
    peel_m_ = height_m;
    actors_->planes->RemoveAllItems();
    if (height_m) {
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(0.0, 0.0, *height_m);
        plane->SetNormal(0.0, 0.0, -1.0);
        actors_->planes->AddItem(plane);
    }
    for (const auto& entry : actors_->entries)
        entry->mapper->Modified();
}

void PointLayer::setPointSize(double size_px) {
    size_px_ = size_px;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
        const double size = std::max(1.0, size_px_ * groups_[i].sizeFactor);
        actors_->entries[i]->actor->GetProperty()->SetPointSize(static_cast<float>(size));
    }
}

void PointLayer::setCoarse(bool coarse) {
    if (coarse_ == coarse || points_.size() <= kCoarseAbove) return;
    coarse_ = coarse;
    for (const auto& entry : actors_->entries)
        entry->data->SetVerts(coarse ? entry->part : entry->all);
}

/// Actors stay when their groups go: making new ones costs more than drawing nothing with them.
void PointLayer::rebuild() {
    const std::size_t stride = points_.size() > kCoarseAbove ? (points_.size() + kCoarsePoints - 1) / kCoarsePoints : 1;
    while (actors_->entries.size() < groups_.size())
        actors_->add();
    for (std::size_t i = 0; i < actors_->entries.size(); ++i) {
        Actors::Entry& entry = *actors_->entries[i];
        entry.all = vertexCell(i < groups_.size() ? groups_[i].indices : std::vector<std::int64_t>(), 1);
        entry.part = stride == 1 || i >= groups_.size() ? entry.all : vertexCell(groups_[i].indices, stride);
        entry.data->SetVerts(coarse_ ? entry.part : entry.all);
        entry.data->Modified();
    }
    setVisible(visible_);
    setOpacity(opacity_);
    setPointSize(size_px_);
}

double typicalSpacing(std::span<const Eigen::Vector3f> points) {
    if (points.size() < 2) return 0.0;
    std::vector<float> squared;
    const std::size_t step = std::max<std::size_t>(1, points.size() / kSpacingProbes);
    for (std::size_t probe = step / 2; probe < points.size(); probe += step) {
        float nearest = std::numeric_limits<float>::infinity();
        for (std::size_t other = 0; other < points.size(); ++other) {
            if (other == probe) continue;
            nearest = std::min(nearest, (points[other] - points[probe]).squaredNorm());
        }
        squared.push_back(nearest);
    }
    const auto middle = squared.begin() + static_cast<std::ptrdiff_t>(squared.size() / 2);
    std::nth_element(squared.begin(), middle, squared.end());
    return std::sqrt(static_cast<double>(*middle));
}

}  // namespace fodscope
