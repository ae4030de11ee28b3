#pragma once

#include "message_log.h"

#include <memory>
#include <QWidget>

namespace lds::ui {

/// Every message sent and received, decoded in words beside its bytes; filter, pause, copy, save.
class MessagesPage final : public QWidget {
    Q_OBJECT

public:
    explicit MessagesPage(MessageLog& log, QWidget* parent = nullptr);
    ~MessagesPage() override;
    void setPeer(const QString& peer); ///< Shows only this sensor's messages when "this sensor" is chosen.

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace lds::ui
