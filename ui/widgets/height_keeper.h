#pragma once

#include <QObject>

class QWidget;

namespace lds::ui {

/// Makes a dialog as high as its texts need at its width. By itself a layout gives a window the height of
/// texts that are not wrapped, and cuts the second line of those that are.
class HeightKeeper final : public QObject {
    Q_OBJECT

public:
    explicit HeightKeeper(QWidget* window); ///< Its child.

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void keep();

    QWidget* m_window;
};

} // namespace lds::ui
