#pragma once

#include "connection_url.h"
#include "recent_connections.h"
#include "serial_ports.h"

#include <optional>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QRadioButton;

namespace lds::ui {

class PortBox;

/// A connection as fields: over Ethernet host and port, over RS-485 port, speed, parity and addresses; type,
/// name and "view only" for both. What is wrong is said beside the field and nothing that was entered is
/// lost, also when the kind is switched. A whole URL pasted into the first field fills the others.
class ConnectionForm final : public QWidget {
    Q_OBJECT

public:
    /// `ports` may be nullptr; else it outlives the form.
    explicit ConnectionForm(const ports::SerialPorts* ports = nullptr, QWidget* parent = nullptr);

    /// The fields' meaning, more than one for a list of RS-485 addresses; nothing when a field is wrong,
    /// which is then said and focused.
    QList<ports::ConnectionUrl> checkAll();
    std::optional<ports::ConnectionUrl> check(); ///< The first of them.
    QString name() const;
    /// Of one of them: the name alone, or with the address when there are several.
    QString nameFor(const ports::ConnectionUrl& url) const;
    void fill(const RecentConnection& connection);
    QString serialPort() const; ///< As entered; may be empty.

Q_SIGNALS:
    void edited();
    void scanRequested(); ///< Somebody does not know the address or the settings on the line.

private:
    struct Field {
        QWidget* column;
        QLineEdit* edit;
        QLabel* error;
    };
    void buildKinds();
    void buildEthernet();
    void buildSerial();
    void buildCommon();
    void connectFields();
    Field addField(const QString& label, const char* name);
    QLabel* addError(QWidget* column, const char* field);
    void addRow(const QString& label, QWidget* field, QWidget* buddy);
    void showKind();
    bool isSerial() const;
    void takeWholeUrl();
    void showUrl();
    void clearErrors();
    QString urlError(const QString& text) const;
    QString hostError() const; ///< Empty when the host can be one.
    QString portError() const;
    QString serialPortError() const;
    QString unitsError() const;
    static void setError(QWidget* edit, QLabel* label, const QString& sentence);
    bool tellErrors();
    QList<ports::ConnectionUrl> urls() const; ///< Of fields that are right.

    QFormLayout* m_form;
    QRadioButton* m_ethernet = nullptr;
    QRadioButton* m_serial = nullptr;
    Field m_host{};
    Field m_port{};
    PortBox* m_serialPort = nullptr;
    QWidget* m_serialPortColumn = nullptr;
    QLabel* m_serialPortError = nullptr;
    QComboBox* m_speed = nullptr;
    QComboBox* m_parity = nullptr;
    Field m_units{};
    Field m_name{};
    const ports::SerialPorts* m_ports;
    QComboBox* m_type = nullptr;
    QCheckBox* m_viewOnly = nullptr;
    QLabel* m_url = nullptr;
};

} // namespace lds::ui
