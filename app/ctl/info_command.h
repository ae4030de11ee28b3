#pragma once

#include "session_command.h"

namespace lds::ctl {

/// ldsctl info: which sensor answers, and how it is.
class InfoCommand final : public SessionCommand {
    Q_OBJECT

public:
    using SessionCommand::SessionCommand;

protected:
    void onReady() override;

private:
    void printJson();
    void printLines();
    QString words(catalog::ItemId item);
    /// Keys of the coils that are set in the status register.
    QStringList setCoils(catalog::ItemId status);
    QStringList selfMonitoring();
    QStringList typesThatFit();
};

} // namespace lds::ctl
