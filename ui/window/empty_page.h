#pragma once

#include <QWidget>

namespace lds::ui {

class WindowActions;

/// What stands in the middle while there is no sensor: the next step, as buttons.
class EmptyPage final : public QWidget {
    Q_OBJECT

public:
    explicit EmptyPage(const WindowActions& actions, QWidget* parent = nullptr);
};

} // namespace lds::ui
