#pragma once

#include "connection_url.h"
#include "recent_connections.h"

#include <optional>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;

namespace lds::ui {

/// Host, port, type, name and "view only" as fields; what is wrong is said beside the field and nothing
/// that was entered is lost. A whole URL pasted into the host field fills the others.
class ConnectionForm final : public QWidget {
    Q_OBJECT

public:
    explicit ConnectionForm(QWidget* parent = nullptr);

    /// The fields' meaning; nothing when one is wrong, which is then said and focused.
    std::optional<ports::ConnectionUrl> check();
    QString name() const;
    void fill(const RecentConnection& connection);

Q_SIGNALS:
    void edited();

private:
    struct Field {
        QLineEdit* edit;
        QLabel* error;
    };
    Field addField(QFormLayout* form, const QString& label, const char* name);
    void takeWholeUrl();
    void showUrl();
    QString hostError() const; ///< Empty when the host can be one.
    QString portError() const;
    static void setError(const Field& field, const QString& sentence);
    ports::ConnectionUrl url() const; ///< Of fields that have been checked.

    Field m_host;
    Field m_port;
    Field m_name;
    QComboBox* m_type;
    QCheckBox* m_viewOnly;
    QLabel* m_url;
};

} // namespace lds::ui
