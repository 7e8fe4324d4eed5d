// SPDX-License-Identifier: MIT
#include "ui/view3d/ShapeLayer.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

namespace fodscope {
namespace {

void append(vtkUnsignedCharArray* colours, const QColor& colour) {
    const unsigned char rgba[] = {static_cast<unsigned char>(colour.red()), static_cast<unsigned char>(colour.green()),
                                  static_cast<unsigned char>(colour.blue()),
                                  static_cast<unsigned char>(colour.alpha())};
    colours->InsertNextTypedTuple(rgba);
}

}  // namespace

class ShapeLayer::Actors {
  public:
    Actors(vtkRenderer* target, double lineWidth_px) : renderer(target) {
        mapper->SetInputData(data);
        mapper->SetColorModeToDirectScalars();
        mapper->SetScalarModeToUseCellData();
        actor->SetMapper(mapper);
        actor->GetProperty()->LightingOff();
        actor->GetProperty()->SetLineWidth(static_cast<float>(lineWidth_px));
        renderer->AddActor(actor);
    }
    ~Actors() { renderer->RemoveActor(actor); }

    vtkSmartPointer<vtkRenderer> renderer;
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
};

ShapeLayer::ShapeLayer(vtkRenderer* renderer, double lineWidth_px)
    : actors_(std::make_unique<Actors>(renderer, lineWidth_px)) {}

ShapeLayer::~ShapeLayer() = default;

void ShapeLayer::setShapes(const Shapes& shapes) {
    bounds_ = shapes.bounds();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToFloat();
    for (const auto& vertex : shapes.vertices)
        points->InsertNextPoint(vertex.data());
    // Cell colours follow VTK's order of cells: lines before triangles.
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(4);
    vtkNew<vtkCellArray> lines;
    for (const Shapes::Line& line : shapes.lines) {
        lines->InsertNextCell(static_cast<int>(line.vertices.size()));
        for (const std::uint32_t vertex : line.vertices)
            lines->InsertCellPoint(vertex);
        append(colours, line.colour);
    }
    vtkNew<vtkCellArray> triangles;
    for (const Shapes::Triangle& triangle : shapes.triangles) {
        triangles->InsertNextCell(3);
        for (const std::uint32_t vertex : triangle.vertices)
            triangles->InsertCellPoint(vertex);
        append(colours, triangle.colour);
    }
    actors_->data->Initialize();
    actors_->data->SetPoints(points);
    actors_->data->SetLines(lines);
    actors_->data->SetPolys(triangles);
    actors_->data->GetCellData()->SetScalars(colours);
    actors_->data->Modified();
}

void ShapeLayer::setVisible(bool visible) {
    actors_->actor->SetVisibility(visible && !empty());
}

void ShapeLayer::setOpacity(double opacity) {
    actors_->actor->GetProperty()->SetOpacity(opacity);
}

}  // namespace fodscope
