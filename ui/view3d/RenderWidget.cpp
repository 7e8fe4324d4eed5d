// SPDX-License-Identifier: MIT
#include "ui/view3d/RenderWidget.h"

#include <QVTKInteractor.h>
#include <QVTKOpenGLNativeWidget.h>
#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QPointer>

#include "core/common/Geometry.h"

namespace fodscope {

class RenderWidget::Impl {
  public:
    explicit Impl(QWidget* parent) : widget(new QVTKOpenGLNativeWidget(parent)) {
        window->SetMultiSamples(0);
        window->SetNumberOfLayers(2);
        renderer->SetLayer(0);
        top->SetLayer(1);
        top->SetActiveCamera(renderer->GetActiveCamera());
        window->AddRenderer(renderer);
        window->AddRenderer(top);
        widget->setRenderWindow(window);
        // The view turns its own camera; VTK's styles let a tank fall on its side.
        if (widget->interactor() != nullptr) widget->interactor()->SetInteractorStyle(nullptr);
        widget->setEnableHiDPI(true);
        renderer->SetTwoSidedLighting(true);
    }

    QPointer<QVTKOpenGLNativeWidget> widget;
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkRenderer> top;
};

RenderWidget::RenderWidget(QWidget* parent) : impl_(std::make_unique<Impl>(parent)) {}

RenderWidget::~RenderWidget() = default;

QWidget* RenderWidget::widget() const {
    return impl_->widget;
}

vtkRenderer* RenderWidget::renderer() const {
    return impl_->renderer;
}

vtkRenderer* RenderWidget::topRenderer() const {
    return impl_->top;
}

void RenderWidget::setBackground(const QColor& colour) {
    impl_->renderer->SetBackground(colour.redF(), colour.greenF(), colour.blueF());
}

void RenderWidget::render(const OrbitCamera& camera) {
    if (impl_->widget == nullptr || impl_->widget->width() < 2 || impl_->widget->height() < 2) return;
    vtkCamera* target = impl_->renderer->GetActiveCamera();
    const Eigen::Vector3d eye = camera.eye();
    const Eigen::Vector3d up = camera.up();
    target->SetPosition(eye.x(), eye.y(), eye.z());
    target->SetFocalPoint(camera.focus.x(), camera.focus.y(), camera.focus.z());
    target->SetViewUp(up.x(), up.y(), up.z());
    target->SetViewAngle(degreesFromRadians(camera.viewAngle_rad));
    target->SetParallelProjection(camera.parallel);
    target->SetParallelScale(0.5 * camera.visibleHeight_m());
    // Both renderers share the camera, so its range holds what both show.
    vtkBoundingBox box;
    for (vtkRenderer* renderer : {impl_->renderer.Get(), impl_->top.Get()}) {
        double bounds[6];
        renderer->ComputeVisiblePropBounds(bounds);
        if (vtkMath::AreBoundsInitialized(bounds)) box.AddBounds(bounds);
    }
    if (box.IsValid()) {
        double bounds[6];
        box.GetBounds(bounds);
        impl_->renderer->ResetCameraClippingRange(bounds);
    }
    impl_->window->Render();
    impl_->widget->update();
}

}  // namespace fodscope
