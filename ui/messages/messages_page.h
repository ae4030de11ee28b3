#pragma once

#include "message_log.h"

#include <memory>
#include <QWidget>

namespace lds::ui {

class MessageModel;

/// Every message sent and received, decoded in words beside its bytes; filter, pause, copy, save.
class MessagesPage final : public QWidget {
    Q_OBJECT

public:
    explicit MessagesPage(MessageLog& log, QWidget* parent = nullptr);
    ~MessagesPage() override;
    void setPeer(const QString& peer); ///< Shows only this sensor's messages when "this sensor" is chosen.

    const MessageModel& model() const;
    QString copyText() const;         ///< What Copy puts on the clipboard: the selected rows, tab separated.
    bool saveTo(const QString& path); ///< The messages shown; says on the page how it went.

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace lds::ui
