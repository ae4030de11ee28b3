#pragma once

#include "keys.h"
#include "session_command.h"

namespace lds::ctl {

/// ldsctl read: the items named, or every item that can be read.
class ReadCommand final : public SessionCommand {
    Q_OBJECT

public:
    using SessionCommand::SessionCommand;

protected:
    bool prepare() override;
    void onReady() override;

private:
    bool addTarget(const QString& key);
    void addEverything();
    void report(const QList<Target>& known);

    QList<Target> m_targets;
};

} // namespace lds::ctl
