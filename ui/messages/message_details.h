#pragma once

#include "frame.h"

#include <QTextEdit>

namespace lds::ui {

/// The selected message in full: what it says, and all its bytes.
class MessageDetails final : public QTextEdit {
    Q_OBJECT

public:
    explicit MessageDetails(QWidget* parent = nullptr);
    void show(const ports::Frame& frame);
    void clear(); ///< Says that a message can be selected.
    QSize sizeHint() const override;
};

} // namespace lds::ui
