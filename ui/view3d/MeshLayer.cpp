// SPDX-License-Identifier: MIT
#include "ui/view3d/MeshLayer.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkFeatureEdges.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm>

#include "ui/theme/Colours.h"

namespace fodscope {
namespace {

constexpr double kSharpEdge_deg = 25.0;

void setColour(vtkProperty* property, const QColor& colour) {
    property->SetColor(colour.redF(), colour.greenF(), colour.blueF());
}

}  // namespace

class MeshLayer::Actors {
  public:
    explicit Actors(vtkRenderer* target) : renderer(target) {
        skinMapper->SetInputData(mesh);
        skinMapper->ScalarVisibilityOff();
        skinMapper->SetClippingPlanes(planes);
        skin->SetMapper(skinMapper);
        // STL meshes have no vertex normals, and their facets are flat.
        skin->GetProperty()->SetInterpolationToFlat();
        skin->GetProperty()->SetAmbient(0.35);
        skin->GetProperty()->SetDiffuse(0.65);
        skin->GetProperty()->SetSpecular(0.0);
        cleaner->SetInputData(mesh);
        sharp->SetInputConnection(cleaner->GetOutputPort());
        sharp->SetFeatureAngle(kSharpEdge_deg);
        sharp->ManifoldEdgesOff();
        sharp->NonManifoldEdgesOff();
        sharp->ColoringOff();
        edgeMapper->SetInputConnection(sharp->GetOutputPort());
        edgeMapper->ScalarVisibilityOff();
        edgeMapper->SetClippingPlanes(planes);
        edges->SetMapper(edgeMapper);
        edges->GetProperty()->LightingOff();
        renderer->AddActor(skin);
        renderer->AddActor(edges);
    }
    ~Actors() {
        renderer->RemoveActor(skin);
        renderer->RemoveActor(edges);
    }

    vtkSmartPointer<vtkRenderer> renderer;
    vtkNew<vtkPolyData> mesh;
    vtkNew<vtkPlaneCollection> planes;
    vtkNew<vtkPolyDataMapper> skinMapper;
    vtkNew<vtkActor> skin;
    vtkNew<vtkCleanPolyData> cleaner;
    vtkNew<vtkFeatureEdges> sharp;
    vtkNew<vtkPolyDataMapper> edgeMapper;
    vtkNew<vtkActor> edges;
};

MeshLayer::MeshLayer(vtkRenderer* renderer) : actors_(std::make_unique<Actors>(renderer)) {}

MeshLayer::~MeshLayer() = default;

void MeshLayer::setMesh(std::span<const Eigen::Vector3d> vertices,
                        std::span<const std::array<std::uint32_t, 3>> triangles) {
    bounds_ = {};
    vtkNew<vtkPoints> points;
    points->SetDataTypeToFloat();
    points->SetNumberOfPoints(static_cast<vtkIdType>(vertices.size()));
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        points->SetPoint(static_cast<vtkIdType>(i), vertices[i].data());
        bounds_.extend(vertices[i]);
    }
    vtkNew<vtkCellArray> cells;
    for (const auto& triangle : triangles) {
        const vtkIdType ids[] = {triangle[0], triangle[1], triangle[2]};
        if (*std::max_element(ids, ids + 3) < static_cast<vtkIdType>(vertices.size())) cells->InsertNextCell(3, ids);
    }
    actors_->mesh->SetPoints(points);
    actors_->mesh->SetPolys(cells);
    actors_->mesh->Modified();
}

void MeshLayer::setTheme(const Theme& theme) {
    setColour(actors_->skin->GetProperty(), mixed(theme.line, theme.muted, 0.45));
    setColour(actors_->edges->GetProperty(), mixed(theme.surface0, theme.muted, 0.6));
}

void MeshLayer::setVisible(bool visible) {
    actors_->skin->SetVisibility(visible && !empty());
    actors_->edges->SetVisibility(visible && !empty());
}

void MeshLayer::setOpacity(double opacity) {
    actors_->skin->GetProperty()->SetOpacity(opacity);
}

void MeshLayer::setPeelHeight(std::optional<double> height_m) {
    actors_->planes->RemoveAllItems();
    if (height_m) {
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(0.0, 0.0, *height_m);
        plane->SetNormal(0.0, 0.0, -1.0);
        actors_->planes->AddItem(plane);
    }
    actors_->skinMapper->Modified();
    actors_->edgeMapper->Modified();
}

}  // namespace fodscope
