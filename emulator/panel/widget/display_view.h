#pragma once

#include "display_content.h"

#include <QWidget>

namespace lds::emulator {

/// The sensor's display by itself, in the largest size of its aspect that fits.
class DisplayView final : public QWidget {
    Q_OBJECT

public:
    explicit DisplayView(QWidget* parent = nullptr);

    void showContent(const DisplayContent& content);
    const DisplayContent& content() const { return m_content; }

    QSize sizeHint() const override { return {320, 160}; }
    QSize minimumSizeHint() const override { return {128, 64}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    DisplayContent m_content;
};

} // namespace lds::emulator
