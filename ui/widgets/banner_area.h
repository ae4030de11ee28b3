#pragma once

#include "banner.h"

#include <functional>
#include <QMap>
#include <QWidget>

namespace lds::ui {

/// The lines that say what is the matter, under each other. Each subject has at most one line, so a state
/// that comes again replaces its own message. The gravest stands on top.
class BannerArea final : public QWidget {
    Q_OBJECT

public:
    struct Message {
        Banner::Kind kind = Banner::Kind::Information;
        QString text;
        QString actionText;           ///< Empty: no button.
        std::function<void()> action; ///< Runs when the button is pressed.
        bool closable = false;
    };

    explicit BannerArea(QWidget* parent = nullptr);

    void showMessage(const QString& subject, const Message& message);
    void hideMessage(const QString& subject);
    void clear();
    /// The line of a subject; nullptr when it has none.
    Banner* find(const QString& subject) const;
    bool isEmpty() const { return m_banners.isEmpty(); }

private:
    void place(Banner* banner);

    QMap<QString, Banner*> m_banners;
    QMap<QString, std::function<void()>> m_actions;
};

} // namespace lds::ui
