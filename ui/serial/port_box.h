#pragma once

#include "serial_ports.h"

#include <QComboBox>

namespace lds::ui {

/// A serial port, chosen from those there are or typed by hand. The list is made anew whenever it opens.
class PortBox final : public QComboBox {
    Q_OBJECT

public:
    /// `ports` may be nullptr: then there is nothing but typing. It outlives the box.
    explicit PortBox(const ports::SerialPorts* ports, QWidget* parent = nullptr);

    QString port() const; ///< As it is opened; empty when nothing is entered.
    void setPort(const QString& port);
    QString error() const; ///< Empty when something is entered.
    void showPopup() override;

Q_SIGNALS:
    void edited(); ///< By a person.

private:
    void refresh();

    const ports::SerialPorts* m_ports;
};

} // namespace lds::ui
