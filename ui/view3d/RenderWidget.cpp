// SPDX-License-Identifier: MIT
#include "ui/view3d/RenderWidget.h"

#include <QVTKInteractor.h>
#include <QVTKOpenGLNativeWidget.h>
#include <vtkCamera.h>
#include <vtkEDLShading.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderer.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderer.h>

#include <QPointer>

#include "core/common/Geometry.h"

namespace fodscope {

class RenderWidget::Impl {
  public:
    explicit Impl(QWidget* parent) : widget(new QVTKOpenGLNativeWidget(parent)) {
        window->SetMultiSamples(0);
        window->AddRenderer(renderer);
        widget->setRenderWindow(window);
        // The view turns its own camera; VTK's styles let a tank fall on its side.
        if (widget->interactor() != nullptr) widget->interactor()->SetInteractorStyle(nullptr);
        widget->setEnableHiDPI(true);
        renderer->SetTwoSidedLighting(true);
        shading->SetDelegatePass(steps);
    }

    QPointer<QVTKOpenGLNativeWidget> widget;
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    vtkNew<vtkOpenGLRenderer> renderer;
    vtkNew<vtkRenderStepsPass> steps;
    vtkNew<vtkEDLShading> shading;
};

RenderWidget::RenderWidget(QWidget* parent) : impl_(std::make_unique<Impl>(parent)) {}

RenderWidget::~RenderWidget() = default;

QWidget* RenderWidget::widget() const {
    return impl_->widget;
}

vtkRenderer* RenderWidget::renderer() const {
    return impl_->renderer;
}

void RenderWidget::setBackground(const QColor& colour) {
    impl_->renderer->SetBackground(colour.redF(), colour.greenF(), colour.blueF());
}

void RenderWidget::setDepthShading(bool on) {
    vtkOpenGLRenderer* renderer = impl_->renderer;
    renderer->SetPass(on ? static_cast<vtkRenderPass*>(impl_->shading) : nullptr);
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
    impl_->renderer->ResetCameraClippingRange();
    impl_->window->Render();
    impl_->widget->update();
}

}  // namespace fodscope
